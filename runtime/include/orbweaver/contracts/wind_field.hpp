#pragma once

#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A body that asks what the air does to it.
struct WindQuery {
    double time = 0;                  ///< s
    std::span<const Vec3> positions;  ///< m
    Vec3 center;                      ///< m, the body's own middle (a web: its hub)
    double radius = 0;                ///< m, the body's extent from there
};

/// Moving air. A field may speak as a velocity (the body turns it into force by its drag), as a force on
/// each point (the thesis's generator), or both.
class WindField {
public:
    static constexpr const char* kContract = "wind_field/1";

    /// Writes the air's velocity (m/s) and the direct force (N) at each position; both spans have the
    /// length of `query.positions` and every element is written. Sampled once a frame, in `sense`.
    /// A pure function of the query.
    virtual void sample(const WindQuery& query, std::span<Vec3> velocity,
                        std::span<Vec3> force) const noexcept = 0;

protected:
    ~WindField() = default;
};

}  // namespace orbweaver
