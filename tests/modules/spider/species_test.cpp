#include "species.hpp"

#include <cmath>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

const std::string kJoints3 = R"(
[joints]
yaw = { limits = ["-60 deg", "50 deg"], comfort = ["-30 deg", "20 deg"], rest = "10 deg" }
tilt = { limits = [-0.4, 0.3], comfort = [-0.2, 0.2], rest = 0.1, stiffness = 1 }
pitch = { limits = [-0.5, 1], comfort = [-0.3, 0.6], rest = 0.5 }
femur = { limits = [-2, 0], comfort = [-1.5, -0.1], rest = -1 }
)";
const std::string kBody = R"([body]
head = ["2 mm", "1 mm", "2 mm"]
thorax = ["4 mm", "2 mm", "4 mm"]
abdomen = ["8 mm", "5 mm", "6 mm"]
)";
const std::string kPair = R"(
[[legs]]
base = ["1 mm", "0.5 mm", "2 mm"]
heading = "60 deg"
bones = { coxa = "1 mm", femur = "5 mm" }
)";

const std::string kWalk = R"(
[walk]
gait = "wave"
speed = "3 cm/s"
duty = [0.8, 0.6]
stride = ["1 mm", "4 mm"]
)";

std::vector<std::string> faults_of(const std::string& text) {
    Diagnostics faults;
    const auto species = read_species_text(text, "bad.toml", faults);
    CHECK(species.has_value() == faults.empty());
    std::vector<std::string> sentences;
    for (const Diagnostic& fault : faults) sentences.push_back(to_string(fault));
    return sentences;
}

Vec3 mirrored(const Vec3& v) { return {v.x, v.y, -v.z}; }

}  // namespace

TEST_CASE("a species file gives a pair of legs for each of its tables", "[unit]") {
    Diagnostics faults;
    const auto species = read_species_text(kBody + kWalk + kJoints3 + kPair, "small", faults);
    REQUIRE(species);
    CHECK(species->name == "small");
    CHECK(species->body.abdomen == Vec3{0.008, 0.005, 0.006});
    REQUIRE(species->limbs.size() == 2);
    const Limb& right = species->limbs[0];
    CHECK(right.name == "R1");
    CHECK(right.base == Vec3{0.001, 0.0005, 0.002});
    CHECK(distance(right.axes.x, {0.5, 0, std::sqrt(0.75)}) < 1e-15);
    CHECK(right.leg.length == Approx(0.006));
    CHECK(right.leg.max[kYaw] == Approx(50 * kDegree));
    CHECK(right.leg.stiffness[kTilt] == 1);
    CHECK(right.leg.stiffness[kYaw] == 0.5);
    for (std::size_t j = 4; j < kJoints; ++j) CHECK((right.leg.min[j] == 0 && right.leg.max[j] == 0));
    const double up = 0.001 * std::sin(0.5) + 0.005 * std::sin(-0.5);
    CHECK(species->height == Approx(-0.0005 - std::cos(0.1) * up));
    CHECK(species->walk.gait == "wave");
    CHECK(species->walk.speed == Approx(0.03));
    CHECK(species->walk.duty == std::array<double, 2>{0.8, 0.6});
    CHECK(species->walk.stride == std::array<double, 2>{0.001, 0.004});
    CHECK(species->body.palp.length == 0);
    CHECK(species->coat.hair == 0);
    CHECK(species->coat.leg > 0);
}

TEST_CASE("a species file says what its creatures look like", "[unit]") {
    Diagnostics faults;
    const auto species = read_species_text(
        kBody + "palps = [\"3 mm\", \"0.4 mm\"]\nchelicerae = [0.002, 0.001]\nwaist = \"0.5 mm\"\n" + kWalk +
            "[coat]\nleg = \"0.7 mm\"\nhair = \"1 mm\"\ngloss = 0.5\nlegs = [0.1, 0.2, 0.3]\n"
            "eyes = [[\"4 mm\", 0, \"1 mm\", \"0.2 mm\"]]\n" +
            kJoints3 + kPair,
        "seen", faults);
    REQUIRE(species);
    CHECK(species->body.palp.length == 0.003);
    CHECK(species->body.palp.thickness == 0.0004);
    CHECK(species->body.chelicera.length == 0.002);
    CHECK(species->body.waist == 0.0005);
    CHECK(species->coat.leg == 0.0007);
    CHECK(species->coat.hair == 0.001);
    CHECK(species->coat.gloss == 0.5);
    CHECK(species->coat.legs == Vec3{0.1, 0.2, 0.3});
    REQUIRE(species->coat.eyes.size() == 1);
    CHECK(species->coat.eyes[0].at == Vec3{0.004, 0, 0.001});
    CHECK(species->coat.eyes[0].radius == 0.0002);
}

TEST_CASE("left legs are right legs in a mirror", "[unit]") {
    const Species species = creature("huntsman");
    for (std::size_t i = 0; i < species.limbs.size(); i += 2) {
        const Limb& right = species.limbs[i];
        const Limb& left = species.limbs[i + 1];
        CHECK(distance(left.home, mirrored(right.home)) < 1e-17);
        LegalPoses poses(right.leg);
        for (int round = 0; round < 100; ++round) {
            LegPose pose = poses.next();
            const Vec3 foot = to_body(right, foot_position(right.leg, pose));
            pose[kYaw] = -pose[kYaw];
            pose[kTilt] = -pose[kTilt];
            CHECK(violation(left.leg, pose) == 0);
            CHECK(distance(to_body(left, foot_position(left.leg, pose)), mirrored(foot)) < 1e-16);
            CHECK(distance(to_limb(left, to_body(left, foot)), foot) < 1e-16);
        }
    }
}

TEST_CASE("creatures that are shipped stand on their feet", "[unit]") {
    for (const std::string& name : kCreatures) {
        INFO(name);
        const Species species = creature(name);
        CHECK(species.limbs.size() == (name == "ant" ? 6 : name == "lizard" ? 4 : 8));
        CHECK(species.height > 0.3 * species.body.thorax.y);
        for (std::size_t i = 0; i < species.limbs.size(); ++i) {
            const Limb& limb = species.limbs[i];
            INFO(limb.name);
            CHECK(violation(limb.leg, rest_pose(limb.leg)) == 0);
            CHECK(std::abs(limb.home.z) > species.body.thorax.z / 2);     // beside the body
            CHECK(limb.home.y == Approx(-species.height).epsilon(0.01));  // level
        }
    }
}

TEST_CASE("a leg's own joints come before those that all legs have in common", "[unit]") {
    Diagnostics faults;
    const auto species =
        read_species_text(kBody + kWalk + kJoints3 + kPair +
                              "joints.yaw = { rest = \"-5 deg\" }\njoints.femur = { limits = [-1.6, 0] }\n",
                          "own", faults);
    REQUIRE(species);
    CHECK(species->limbs[0].leg.rest[kYaw] == Approx(-5 * kDegree));
    CHECK(species->limbs[0].leg.max[kYaw] == Approx(50 * kDegree));
    CHECK(species->limbs[0].leg.min[3] == -1.6);
    CHECK(species->limbs[0].leg.comfort_min[3] == -1.5);
}

TEST_CASE("a bad species file is told all that is wrong with it, and where", "[unit]") {
    struct Case {
        std::string name, text;
        std::vector<std::string> expected;
    };
    const std::vector<Case> cases{
        {"not TOML", "body = [", {"bad.toml:1:9: Error while parsing array"}},
        {"nothing in it",
         "",
         {"bad.toml:1:1: 'body' is missing; expected a table",
          "bad.toml:1:1: 'walk' is missing; expected a table",
          "bad.toml:1:1: 'joints' is missing; expected a table",
          "bad.toml:1:1: 'legs' is missing; expected [[legs]], one for each pair"}},
        {"a wrong unit, a wrong count and an unknown key",
         "[body]\nhead = [\"2 mm\", \"1 kg\", \"2 mm\"]\nthorax = [1, 2]\nabdomen = [1, 1, 1]\nwings = 2\n" +
             kJoints3 + kPair + kWalk,
         {"bad.toml:2:17: 'head' is \"1 kg\"; expected 1e-06 to 10 m",
          "bad.toml:3:10: 'thorax' is an array of 2; expected an array of 3",
          "bad.toml:5:1: a body has no key 'wings'; expected head, thorax, abdomen, waist, chelicerae, palps "
          "or bend"}},
        {"comfort outside of limits, and a tilt that meets yaw",
         kBody +
             "[joints]\nyaw = { limits = [-1, 1], comfort = [-2, 1], rest = 0 }\n"
             "tilt = { limits = [0, \"85 deg\"], comfort = [0, 0], rest = 0 }\n"
             "pitch = { limits = [0, 0], comfort = [0, 0], rest = 0, stiffness = 2 }\n"
             "femur = { limits = [0, 0], comfort = [0, 0] }\n" +
             kPair + kWalk,
         {"bad.toml:7:23: 'limits' is \"85 deg\"; expected -1.396 to 1.396 rad",
          "bad.toml:8:68: 'stiffness' is 2; expected 0 to 1",
          "bad.toml:6:7: joints.yaw has limits -57.3 to 57.3 deg, comfort -114.6 to 57.3 deg and rest 0.0 deg",
          "bad.toml:9:9: 'joints.femur.rest' is missing; expected an angle"}},
        {"legs of nothing",
         kBody + kJoints3 +
             "[[legs]]\nbones = {}\n[[legs]]\nbase = 1\nheading = 0\nbones = { thigh = 1 "
             "}\n" +
             kWalk,
         {"bad.toml:11:1: 'base' is missing; expected [forward, up, right] of the right leg",
          "bad.toml:11:1: 'heading' is missing; expected an angle from forward to the right",
          "bad.toml:12:9: the leg has no bones; expected at least one",
          "bad.toml:14:8: 'base' is 1; expected an array of 3",
          "bad.toml:16:9: the leg has no bones; expected at least one",
          "bad.toml:16:11: a leg's bones has no key 'thigh'; expected coxa, femur"}},
        {"no array of legs",
         "legs = 8\n" + kBody + kJoints3 + kWalk,
         {"bad.toml:1:8: 'legs' is 8; expected an array of 1 to 8 pairs"}},
        {"a back that is never straight, and half a palp",
         kBody + "bend = [\"5 deg\", \"20 deg\"]\npalps = [1]\n" + kJoints3 + kPair + kWalk,
         {"bad.toml:6:9: 'palps' is an array of 1; expected an array of 2",
          "bad.toml:5:8: 'bend' is 5.0 to 20.0 deg; expected 0, a straight back, within it"}},
        {"nothing of a walk",
         "[walk]\n" + kBody + kJoints3 + kPair,
         {"bad.toml:1:1: 'gait' is missing; expected tetrapod, ripple, wave",
          "bad.toml:1:1: 'speed' is missing; expected a speed",
          "bad.toml:1:1: 'duty' is missing; expected [at rest, at top speed]",
          "bad.toml:1:1: 'stride' is missing; expected [at rest, at top speed]"}},
        {"a walk that nobody walks",
         "[walk]\ngait = \"trot\"\nspeed = \"1 kg\"\nduty = [0.6, 0.7]\nstride = [2, 1]\nlegs = 8\n" + kBody +
             kJoints3 + kPair,
         {"bad.toml:2:8: 'gait' is \"trot\"; expected tetrapod, ripple, wave",
          "bad.toml:3:9: 'speed' is \"1 kg\"; expected 1e-06 to 100 m/s",
          "bad.toml:4:8: 'duty' is larger at top speed than at rest; expected the larger first",
          "bad.toml:5:10: 'stride' is longer at rest than at top speed; expected the shorter first",
          "bad.toml:6:1: a walk has no key 'legs'"}},
        {"feet above the body",
         kBody + kJoints3 + kPair + "joints.femur = { limits = [0, 2], comfort = [0, 1.5], rest = 1 }\n" +
             kWalk,
         {"bad.toml:1:1: the feet at rest are 5.94 mm above the thorax's middle, on average; expected feet "
          "below "
          "it; turn the legs' joints down at rest, or their bases"}},
        {"a belly deeper than legs reach",
         "[body]\nhead = [0.002, 0.001, 0.002]\nthorax = [0.004, 0.1, 0.004]\nabdomen = [0.008, 0.005, "
         "0.006]\n" +
             kJoints3 + kPair + kWalk,
         {"bad.toml:1:1: leg R1 does not reach the ground, ",
          "bad.toml:1:1: leg L1 does not reach the ground, "}},
        {"a coat of no stuff",
         "[coat]\nhair = \"1 s\"\nlegs = [1, 2, 0]\neyes = [[0, 0, 0, 0], 3]\nfur = 1\n" + kBody + kJoints3 +
             kPair + kWalk,
         {"bad.toml:2:8: 'hair' is \"1 s\"; expected 1e-07 to 1 m",
          "bad.toml:3:12: 'legs' is 2; expected 0 to 1",
          "bad.toml:4:9: an eye's radius is not above 0; expected [forward, up, right, radius]",
          "bad.toml:4:23: 'eyes' is 3; expected an array of 4", "bad.toml:5:1: a coat has no key 'fur'"}},
    };
    for (const Case& each : cases) {
        INFO(each.name);
        const auto sentences = faults_of(each.text);
        for (const std::string& sentence : sentences) UNSCOPED_INFO(sentence);
        REQUIRE(sentences.size() == each.expected.size());
        for (std::size_t i = 0; i < sentences.size(); ++i)
            CHECK(sentences[i].substr(0, each.expected[i].size()) == each.expected[i]);
    }
    Diagnostics faults;
    CHECK_FALSE(read_species_file("/nowhere/creature.toml", faults));
    REQUIRE(faults.size() == 1);
    CHECK(to_string(faults[0]) ==
          "/nowhere/creature.toml: there is no such file; expected a TOML file; check the path");
}
