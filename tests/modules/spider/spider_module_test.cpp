#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <string>

#include "orbweaver/contracts/creatures.hpp"
#include "run/snapshot.hpp"
#include "scene/toml_reader.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

/// A scene given as text, with a flat floor of 2 m before its tables, opened as the program does.
struct Opened {
    Catalog catalog = read_catalog({ORBWEAVER_MODULE_DIR});
    Plan plan;
    std::unique_ptr<Session> session;

    explicit Opened(const std::string& tables, const std::string& surface = "floor = \"2 m\"") {
        const std::string text = "[surface]\n" + surface + "\n" + tables;
        plan = make_plan(read_toml_text(text, "scene.toml"), "scene.toml", catalog, {});
        for (const Diagnostic& fault : plan.faults) FAIL(to_string(fault));
        session = std::make_unique<Session>(plan, Request{});
    }
    void run(double seconds) const {
        for (int i = 0; i < std::lround(seconds * 60); ++i) session->step();
    }
    std::vector<std::string> faults() const {
        std::vector<std::string> all;
        for (const Diagnostic& fault : session->faults()) all.push_back(to_string(fault));
        return all;
    }
    std::span<const Vec3> state(const char* name, std::size_t spider = 0) const {
        std::size_t number = 0;
        for (const auto& instance : session->instances()) {
            if (instance->manifest().id != "spider" || number++ != spider) continue;
            for (const StateBlock::Entry& entry : instance->block().entries())
                if (entry.name == name)
                    return {static_cast<const Vec3*>(entry.memory()), entry.bytes() / sizeof(Vec3)};
        }
        FAIL("there is no " << name);
        return {};
    }
    Vec3 position(std::size_t spider = 0) const { return state("position", spider)[0]; }
};

/// From +x towards -z, so that to the left is positive.
double heading(const Vec3& forward) { return std::atan2(-forward.z, forward.x) * 180 / std::acos(-1.0); }

const std::string kStill = "rests = false\nwander.weight = 0\nposition = [0, 0, 0]\n";

}  // namespace

TEST_CASE("a script turns the head by its rate times its time, to the left, and ends", "[unit]") {
    const Opened opened(
        "[[spider]]\n" + kStill +
        "control = [{ at = \"0.5 s\", for = \"1 s\", turn = \"60 deg/s\" }, { at = \"2 s\", for = "
        "\"0.5 s\", turn = \"-1 rad/s\" }]\n");
    opened.run(0.5);
    CHECK(std::abs(heading(opened.state("forward")[0])) < 1e-9);
    opened.run(1.2);
    CHECK(heading(opened.state("forward")[0]) == Approx(60).margin(1e-6));
    opened.run(1.0);
    CHECK(heading(opened.state("forward")[0]) == Approx(60 - 0.5 * 180 / std::acos(-1.0)).margin(1e-6));
}

TEST_CASE("who is told to go faster than it can goes as fast as it can", "[unit]") {
    const Opened opened("[[spider]]\n" + kStill + "speed = 0.1\ncontrol = [{ speed = 50 }]\n");
    opened.run(4);
    CHECK(norm(opened.state("velocity")[0]) == Approx(0.1).epsilon(1e-6));
    CHECK(opened.position().x > 0.35);
}

TEST_CASE("a state is not restored onto another surface", "[unit]") {
    const Opened hill("[[spider]]\n", "shape = \"height_field\"\nsubdivision = 100");
    hill.run(1);
    const std::string saved = save_snapshot(*hill.session);
    for (const char* other :
         {"shape = \"height_field\"\nsubdivision = 2", "shape = \"cube\"\nsubdivision = 200"}) {
        const Opened changed("[[spider]]\n", other);
        try {
            restore_snapshot(*changed.session, saved, "saved");
            FAIL("it was restored");
        } catch (const Fault& fault) {
            CHECK(fault.kind() == FaultKind::invalid);
            CHECK(std::string(fault.what()).find("does not stand on this surface") != std::string::npos);
        }
    }
    const Opened same("[[spider]]\n", "shape = \"height_field\"\nsubdivision = 100");
    CHECK(restore_snapshot(*same.session, saved, "saved"));
}

TEST_CASE("nobody turns faster by hand than its turn rate", "[unit]") {
    const Opened opened("[[spider]]\n" + kStill + "turn_rate = 45\ncontrol = [{ turn = \"200 deg/s\" }]\n");
    opened.run(1);
    CHECK(heading(opened.state("forward")[0]) == Approx(45).margin(1e-6));
}

TEST_CASE("a script walks at its speed, whatever the creature wants, and a curve is a circle", "[unit]") {
    const std::string wants = "rests = true\nposition = [0, 0, 0]\nseek.point = [-0.5, 0, 0]\n";
    const Opened straight("[[spider]]\n" + wants + "control = [{ speed = \"6 cm/s\" }]\n");
    straight.run(5);
    // Forward Euler comes to its speed as (1 - (1 - dt / 0.15 s)^n): 0.06 m/s * (0.15 s - dt) are lost.
    const double way = 0.06 * (5 - (0.15 - 1.0 / 60));
    CHECK(straight.position().x == Approx(way).margin(1e-9));
    CHECK(std::abs(straight.position().z) < 1e-12);
    const Opened back("[[spider]]\n" + wants + "control = [{ speed = \"-6 cm/s\" }]\n");
    back.run(5);
    CHECK(back.position().x == Approx(-way).margin(1e-9));
    const Opened round("[[spider]]\n" + wants + "control = [{ speed = \"6 cm/s\", turn = \"36 deg/s\" }]\n");
    round.run(1);
    const Vec3 start = round.position();
    round.run(5);
    const Vec3 middle = 0.5 * (start + round.position());  // half a circle of 0.06 m/s / (pi / 5 s)
    CHECK(norm(start - middle) == Approx(0.06 * 5 / std::acos(-1.0)).epsilon(0.02));
    round.run(5);
    CHECK(distance(round.position(), start) < 2e-3);
}

TEST_CASE("who is led to a border stands there, and may turn back", "[unit]") {
    const Opened opened(
        "[[spider]]\n" + kStill +
            "control = [{ speed = 0.06 }, { at = 4, speed = 0.06, turn = 60 }, { at = 7, speed = 0.06 }]\n",
        "floor = \"0.3 m\"");
    opened.run(4);
    const double x = opened.position().x;
    CHECK(x > 0.1);
    CHECK(x < 0.15);
    CHECK(norm(opened.state("velocity")[0]) < 1e-6);
    opened.run(5);
    CHECK(opened.position().x < x - 0.1);
}

TEST_CASE("only the first of a table obeys", "[unit]") {
    const Opened opened("[[spider]]\ncount = 2\n" + kStill +
                        "keep_apart.weight = 0\ncontrol = [{ turn = 30 }]\n");
    const Vec3 before = opened.state("forward")[1];
    opened.run(1);
    CHECK(heading(opened.state("forward")[0]) == Approx(30).margin(1e-6));
    CHECK(opened.state("forward")[1] == before);
}

TEST_CASE("groups hunt and evade each other by name, in whatever order their tables stand", "[unit]") {
    const std::string hunter =
        "[[spider]]\nname = \"hunter\"\nposition = [-0.3, 0, 0]\nrests = false\nspeed = "
        "0.14\npursue.target = \"prey\"\n";
    const std::string prey =
        "[[spider]]\nname = \"prey\"\nposition = [0, 0, 0]\nrests = false\nspeed = "
        "0.06\nwander.weight = 0\nevade = { target = \"hunter\", within = 0.2 }\n";
    for (const bool hunter_first : {true, false}) {
        const Opened opened(hunter_first ? hunter + prey : prey + hunter);
        REQUIRE(opened.faults().empty());
        const auto off = [&] { return distance(opened.position(0), opened.position(1)); };
        const Vec3 start = opened.position(hunter_first ? 1 : 0);
        opened.run(0.4);
        CHECK(opened.position(hunter_first ? 1 : 0) == start);
        opened.run(3);
        CHECK(opened.position(hunter_first ? 1 : 0).x > 0.05);
        CHECK(off() < 0.05);  // 0.3 m at 0.08 m/s, and what the prey stood still for
    }
}

TEST_CASE("tables of one name are one group: the nearest of all is hunted", "[unit]") {
    const std::string still = "rests = false\nwander.weight = 0\nkeep_apart.weight = 0\n";
    const Opened opened("[[spider]]\nposition = [0, 0, 0]\npursue.target = \"prey\"\n" + still +
                        "[[spider]]\nname = \"prey\"\nposition = [0.4, 0, 0]\n" + still +
                        "[[spider]]\nname = \"prey\"\nposition = [-0.3, 0, 0]\n" + still);
    opened.run(3);  // half of it to turn round
    CHECK(opened.position().x < -0.1);
}

TEST_CASE("a name that nobody has is refused before the run, with those there are", "[extreme]") {
    const Opened opened("[[spider]]\nname = \"hunter\"\npursue.target = \"pray\"\n[[spider]]\n");
    CHECK(opened.faults() ==
          std::vector<std::string>{"scene.toml:5:17: no creatures are called 'pray'; expected one of hunter, "
                                   "spider.2; give them a name in their table"});
}

TEST_CASE("a crowd of a hundred keeps apart", "[unit]") {
    const Opened opened("[[spider]]\nspecies = \"jumping_spider\"\ncount = 100\nwander.displacement = 0.5\n",
                        "floor = \"0.5 m\"");
    opened.run(4);
    const auto places = opened.state("position");
    double nearest = 1;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) nearest = std::min(nearest, distance(places[i], places[k]));
    CHECK(nearest > 0.004);  // a body is 2 mm wide to each side
}

TEST_CASE("two groups keep apart, but a hunter from its quarry does not", "[unit]") {
    const std::string still = "rests = false\nwander.weight = 0\n";
    const Opened apart("[[spider]]\nposition = [0, 0, 0]\n" + still + "[[spider]]\nposition = [0.03, 0, 0]\n" +
                       still);
    const double before = distance(apart.position(0), apart.position(1));
    apart.run(1);
    CHECK(distance(apart.position(0), apart.position(1)) > before + 0.02);
}

TEST_CASE("nobody is placed on glass: not where it is asked for, and not at random", "[unit]") {
    const std::string room = "shape = \"room\"\nsubdivision = 2\nclimbable = false\nfriction = 0.5";
    const Opened asked("[[spider]]\nposition = [0.5, 0, 0]\n", room);
    CHECK(asked.faults() ==
          std::vector<std::string>{"scene.toml:7:12: creature 0 cannot hold on to the surface "
                                   "where it is placed"});
    const Opened random("[[spider]]\ncount = 30\n", room);
    REQUIRE(random.faults().empty());
    for (const Vec3& up : random.state("up")) CHECK(up.y == 1);  // the floor alone is level enough
    random.run(3);
    for (const Vec3& p : random.state("position")) CHECK(p.y < -0.4);
}
