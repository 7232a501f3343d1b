#pragma once

#include <array>
#include <span>
#include <vector>

#include "creature.hpp"

namespace orbweaver::spider {

/// Bones of a creature: those of its body, then kBones of each leg. Head, thorax and abdomen are its backbone;
/// chelicerae and palps hang on the head, which does not turn against the thorax: a spider's are one.
enum BodyBone : std::size_t {
    kThorax,
    kHead,
    kAbdomen,
    kRightChelicera,
    kLeftChelicera,
    kRightPalp,
    kLeftPalp,
    kBodyBones,
};
inline std::size_t bone_count(const Species& species) noexcept {
    return kBodyBones + kBones * species.limbs.size();
}

/// Where a bone begins, m, and how it lies, body frame: x along it, of legs, palps and chelicerae z across.
struct BonePlace {
    Vec3 at;
    Frame axes;
};

/// How the joints of a creature stand, rad.
struct SkeletonPose {
    double bend = 0;                     ///< of the abdomen, up
    std::array<double, 2> palps{};       ///< right, left: up
    std::array<double, 2> chelicerae{};  ///< right, left: apart
    std::span<const LegPose> legs;
};

/// Palps and chelicerae move while it stands at random, as twitch() says.
SkeletonPose skeleton_pose(const Conduct& conduct, const CreatureState& state) noexcept;
/// As its species has it.
std::vector<LegPose> rest_poses(const Species& species);

/// All bone_count() of them.
void place_bones(const Species& species, const SkeletonPose& pose, std::span<BonePlace> places) noexcept;

}  // namespace orbweaver::spider
