#include "skeleton.hpp"

#include <algorithm>

#include "posture.hpp"
#include "rotor.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kCalm = 0.15;  // s before it walks on, in which they come to rest
constexpr double kPalpSwing = 22 * kDegree;
constexpr double kCheliceraSwing = 5 * kDegree;
constexpr double kPalpHeading = 18 * kDegree;     // to its side
constexpr double kCheliceraSlope = 58 * kDegree;  // downward

/// x to the right by `heading` and up by `rise`, z level.
Frame pointing(double heading, double rise) noexcept {
    const Rotor<double> h = rotor(heading), r = rotor(rise);
    const Vec3 x{h.c * r.c, r.s, h.s * r.c}, z{-h.s, 0, h.c};
    return {x, cross(z, x), z};
}

void place_head_parts(const Body& body, const SkeletonPose& pose, std::span<BonePlace> places) noexcept {
    const double front = body.thorax.x / 2;
    for (const std::size_t left : {0, 1}) {
        const double side = left == 0 ? 1 : -1;
        places[kRightChelicera + left] = {
            {front + 0.78 * body.head.x, -0.12 * body.head.y, side * 0.55 * body.chelicera.thickness},
            pointing(side * pose.chelicerae[left], -kCheliceraSlope)};
        places[kRightPalp + left] = {{front + 0.6 * body.head.x, -0.2 * body.head.y, side * 0.36 * body.head.z},
                                     pointing(side * kPalpHeading, pose.palps[left])};
    }
}

void place_leg(const Limb& limb, const LegPose& pose, std::span<BonePlace> places) noexcept {
    double angles[kJoints];
    std::copy(pose.begin(), pose.end(), angles);
    const Posture<double> at = posture(limb.leg, angles);
    const auto turned = [&](double x, double y, double z) {
        const Triple<double> v = from_plane(at, Triple<double>{x, y, z});
        return v.x * limb.axes.x + v.y * limb.axes.y + v.z * limb.axes.z;
    };
    for (std::size_t i = 0; i < kBones; ++i) {
        const Rotor<double>& along = at.along[i];
        places[i] = {limb.base + limb.leg.length * turned(at.x[i], at.y[i], 0),
                     {turned(along.c, along.s, 0), turned(-along.s, along.c, 0), turned(0, 0, 1)}};
    }
}

}  // namespace

SkeletonPose skeleton_pose(const Conduct& conduct, const CreatureState& state) noexcept {
    SkeletonPose pose;
    pose.bend = state.bend;
    const double ending = std::min(1.0, state.pause.left / kCalm);
    for (const std::size_t left : {0, 1}) {
        const double raised = ending * twitch(conduct.pauses, state.pause, left == 0);
        pose.palps[left] = kPalpSwing * raised;
        pose.chelicerae[left] = kCheliceraSwing * raised * raised;
    }
    pose.legs = std::span(state.poses).first(conduct.species->limbs.size());
    return pose;
}

std::vector<LegPose> rest_poses(const Species& species) {
    std::vector<LegPose> poses;
    for (const Limb& limb : species.limbs) poses.push_back(rest_pose(limb.leg));
    return poses;
}

void place_bones(const Species& species, const SkeletonPose& pose, std::span<BonePlace> places) noexcept {
    const double front = species.body.thorax.x / 2;
    const Rotor<double> bend = rotor(pose.bend);
    places[kThorax] = {{}, pointing(0, 0)};
    places[kHead] = {{front, 0, 0}, pointing(0, 0)};
    places[kAbdomen] = {{-front, 0, 0}, {{-bend.c, bend.s, 0}, {bend.s, bend.c, 0}, {0, 0, -1}}};
    place_head_parts(species.body, pose, places);
    for (std::size_t leg = 0; leg < species.limbs.size(); ++leg)
        place_leg(species.limbs[leg], pose.legs[leg], places.subspan(kBodyBones + kBones * leg, kBones));
}

}  // namespace orbweaver::spider
