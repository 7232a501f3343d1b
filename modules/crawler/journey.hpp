#pragma once

#include "orbweaver/vec3.hpp"

namespace orbweaver::crawler {

/// How far a body got, cycle by cycle of its gait. The first cycle, in which muscles only begin, does not
/// count.
struct Journey {
    Vec3 start;               ///< m, its center of mass at the start
    Vec3 mark;                ///< m, its center of mass where the last whole cycle ended
    double mark_time = 0;     ///< s, then
    double cycle = 0;         ///< number of whole cycles that ended so far
    double way = 0;           ///< m, from end to end of cycles
    double time = 0;          ///< s, that these took
    double cycles = 0;        ///< number of these
    double volume_error = 0;  ///< largest change of the body's volume, over that at rest

    /// At `now` (s), `all` cycles of the gait are over and the center is there.
    void go_on(const Vec3& center, double now, double all) noexcept;
    /// m/s, over whole cycles; over what there was, where there was no second one.
    double speed(const Vec3& center, double now) const noexcept;
    /// m, that a cycle leads on, likewise, after `all` cycles.
    double way_a_cycle(const Vec3& center, double all) const noexcept;
};

}  // namespace orbweaver::crawler
