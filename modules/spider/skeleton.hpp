#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "creature.hpp"
#include "orbweaver/contracts/threads.hpp"

namespace orbweaver::spider {

inline constexpr std::array<std::string_view, 2> kSkeletonKinds{"body", "leg"};

/// The bones of creatures as lines, to be seen: from the head through the thorax to the abdomen's end, and of
/// each leg.
class Skeleton {
public:
    Skeleton() = default;
    Skeleton(const Species& species, std::size_t count);
    void pose(const Conduct& conduct, std::span<const CreatureState> creatures) noexcept;

    std::span<const Vec3> points() const noexcept { return points_; }
    std::span<const ThreadSegment> segments() const noexcept { return segments_; }
    std::size_t memory_bytes() const noexcept {
        return points_.capacity() * sizeof(Vec3) + segments_.capacity() * sizeof(ThreadSegment);
    }

private:
    std::vector<Vec3> points_;  ///< m; of each creature: 4 of the body, then kBones + 1 of each leg
    std::vector<ThreadSegment> segments_;
};

}  // namespace orbweaver::spider
