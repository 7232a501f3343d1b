#include "skeleton.hpp"

#include "walking.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

std::vector<BonePlace> placed(const Species& species, const SkeletonPose& pose) {
    std::vector<BonePlace> places(bone_count(species));
    place_bones(species, pose, places);
    return places;
}

double worst_axes(const Frame& f) {
    return std::max({std::abs(norm(f.x) - 1), std::abs(norm(f.y) - 1), distance(cross(f.x, f.y), f.z)});
}

}  // namespace

TEST_CASE("bones of a leg begin where its joints are, and end at its foot", "[unit]") {
    const Species species = creature("tarantula");
    auto legs = rest_poses(species);
    for (std::size_t leg = 0; leg < legs.size(); ++leg) legs[leg] = LegalPoses(species.limbs[leg].leg).next();
    SkeletonPose pose;
    pose.bend = 0.3;
    pose.palps = {0.2, -0.1};
    pose.legs = legs;
    const auto places = placed(species, pose);
    for (const BonePlace& place : places) CHECK(worst_axes(place.axes) < 1e-14);
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
        const Limb& limb = species.limbs[leg];
        const auto joints = joint_positions(limb.leg, legs[leg]);
        for (std::size_t i = 0; i < kBones; ++i) {
            const BonePlace& bone = places[kBodyBones + kBones * leg + i];
            CHECK(distance(bone.at, to_body(limb, joints[i])) < 1e-16);
            const Vec3 end = bone.at + limb.leg.bone[i] * limb.leg.length * bone.axes.x;
            CHECK(distance(end, to_body(limb, joints[i + 1])) < 1e-15);
        }
    }
}

TEST_CASE("a bend lifts the abdomen about the thorax's back, palps turn up, chelicerae apart", "[unit]") {
    const Species species = creature("huntsman");
    const auto legs = rest_poses(species);
    SkeletonPose rest;
    rest.legs = legs;
    SkeletonPose pose = rest;
    pose.bend = 0.5;
    pose.palps = {0.4, 0};
    pose.chelicerae = {0.1, 0.1};
    const auto before = placed(species, rest), after = placed(species, pose);
    CHECK(distance(after[kAbdomen].at, {-species.body.thorax.x / 2, 0, 0}) == 0);
    CHECK(distance(after[kAbdomen].axes.x, {-std::cos(0.5), std::sin(0.5), 0}) < 1e-15);
    CHECK(after[kHead].at == before[kHead].at);
    CHECK(after[kRightPalp].axes.x.y == Approx(std::sin(0.4)));
    CHECK(after[kLeftPalp].axes.x == before[kLeftPalp].axes.x);
    CHECK(after[kRightChelicera].axes.x.z > 0);
    CHECK(after[kLeftChelicera].axes.x.z == Approx(-after[kRightChelicera].axes.x.z));
    CHECK(before[kRightPalp].at.z == -before[kLeftPalp].at.z);
}

TEST_CASE("palps and chelicerae are still but in pauses", "[unit]") {
    const Conduct conduct = walking(huntsman());
    const RandomStream random(3, "palps");
    CreatureState state;
    double most = 0;
    int stood = 0;
    for (int i = 0; i < 3600; ++i) {
        advance_pauses(conduct.pauses, random, 1.0 / 60, state.pause);
        const SkeletonPose pose = skeleton_pose(conduct, state);
        for (const std::size_t left : {0, 1}) {
            if (!state.pause.stands) CHECK((pose.palps[left] == 0 && pose.chelicerae[left] == 0));
            most = std::max(most, std::abs(pose.palps[left]));
            CHECK(pose.chelicerae[left] >= 0);
        }
        stood += state.pause.stands ? 1 : 0;
    }
    REQUIRE(stood > 300);
    CHECK(most > 10 * kDegree);
    CHECK(most <= 22 * kDegree);
}

TEST_CASE("palps do not jump when a pause begins or ends", "[unit]") {
    constexpr double kStep = 1e-3;
    const Conduct conduct = walking(huntsman());
    const RandomStream random(3, "palps");
    CreatureState state;
    double last = 0;
    int changes = 0;
    for (int i = 0; i < 60000; ++i) {
        const bool stood = state.pause.stands;
        advance_pauses(conduct.pauses, random, kStep, state.pause);
        const double palp = skeleton_pose(conduct, state).palps[0];
        // 7 and 0.6 turns a second of 22 degrees, and as many in the 0.15 s before it walks on.
        CHECK(std::abs(palp - last) < kStep * 22 * kDegree * (2 * 3.1416 * 7.6 + 1 / 0.15));
        last = palp;
        changes += state.pause.stands != stood ? 1 : 0;
    }
    CHECK(changes > 10);
}
