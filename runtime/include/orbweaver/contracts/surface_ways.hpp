#pragma once

#include <cstdint>
#include <span>

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver {

/// Ways of answering one question to a surface, for a study that holds their errors and costs against each
/// other. The question is a Stance: what lies on the ray from its position against its up (unit), within reach?
class SurfaceWays {
public:
    static constexpr const char* kContract = "surface_ways/1";

    enum class Finds : std::uint8_t {
        crossing,   ///< the ray's nearest crossing
        nearest,    ///< the point nearest to the position, wherever the ray goes
        underfoot,  ///< the crossing that lies on the surface around Stance::last; else a place nearby
    };
    struct Way {
        const char* name;     ///< "wide_tree"
        const char* meaning;  ///< in a few words
        Finds finds;
    };

    virtual std::span<const Way> ways() const noexcept = 0;
    /// Answers every question by the way of that number. `hits` has a place for each question.
    virtual void answer(std::size_t way, std::span<const Stance> questions,
                        std::span<SurfaceHit> hits) const noexcept = 0;

protected:
    ~SurfaceWays() = default;
};

}  // namespace orbweaver
