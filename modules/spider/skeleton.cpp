#include "skeleton.hpp"

namespace orbweaver::spider {
namespace {

constexpr std::uint32_t kBodyPoints = 4;
constexpr std::uint32_t kLegPoints = kBones + 1;

}  // namespace

Skeleton::Skeleton(const Species& species, std::size_t count) {
    const auto legs = static_cast<std::uint32_t>(species.limbs.size());
    const std::uint32_t per_creature = kBodyPoints + legs * kLegPoints;
    points_.resize(count * per_creature);
    const auto chain = [&](std::uint32_t first, std::uint32_t points, std::uint32_t kind) {
        for (std::uint32_t i = 0; i + 1 < points; ++i) segments_.push_back({first + i, first + i + 1, kind});
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        chain(i * per_creature, kBodyPoints, 0);
        for (std::uint32_t leg = 0; leg < legs; ++leg)
            chain(i * per_creature + kBodyPoints + leg * kLegPoints, kLegPoints, 1);
    }
}

void Skeleton::pose(const Conduct& conduct, std::span<const CreatureState> creatures) noexcept {
    const Body& body = conduct.species->body;
    Vec3* to = points_.data();
    for (const CreatureState& creature : creatures) {
        const BodyPose pose = pose_of(conduct, creature);
        const double front = body.thorax.x / 2;
        for (const double along : {front + body.head.x, front, -front, -front - body.abdomen.x})
            *to++ = to_world(pose, {along, 0, 0});
        for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) {
            const Limb& limb = conduct.species->limbs[leg];
            for (const Vec3& joint : joint_positions(limb.leg, creature.poses[leg]))
                *to++ = to_world(pose, to_body(limb, joint));
        }
    }
}

}  // namespace orbweaver::spider
