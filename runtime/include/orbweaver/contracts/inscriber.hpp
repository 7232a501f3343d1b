#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "orbweaver/contracts/threads.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A web at rest, as whoever writes in it sees it.
struct WebAtRest {
    std::span<const Vec3> points;  ///< m
    std::span<const ThreadSegment>
        segments;                     ///< those of the plain web that are kept, in its order; then others
    std::span<const double> tension;  ///< N, of each segment; below 0: slack
    std::span<const std::string_view> kinds;  ///< "radius", "spiral", ...
    Vec3 center;                              ///< m, of the hub
    Vec3 right, up;                           ///< unit, in the web's plane, as a viewer sees it
    double mesh_width = 0;                    ///< m, between neighboring turns of the spiral; 0: there is none
    double residual = 0;                      ///< N, largest net force on a point that is free
};

/// What is to be changed in a web; segments and points by their place in the plain one.
struct WebChange {
    /// A new thread between two points, of the sort of another and as taut as that.
    struct Added {
        std::uint32_t a = 0, b = 0;
        std::uint32_t like = 0;  ///< segment
        double width = 1;        ///< times as much silk as that
    };
    /// More silk along a part of a segment: as taut as before, `width` times as stiff.
    struct Thickened {
        std::uint32_t segment = 0;
        double from = 0, to = 1;  ///< shares of its length, from < to
        double width = 1;
    };

    std::vector<std::uint32_t> removed;  ///< segments, none twice
    std::vector<Added> added;
    std::vector<Thickened> thickened;  ///< of segments that stay; parts of one do not overlap
};

/// A web that can be tried in other forms before time starts.
class WebDraft {
public:
    /// As it is without any change.
    virtual const WebAtRest& plain() const noexcept = 0;
    /// Makes that change to the plain web, and lets it come to rest. What it returns holds until the next call.
    /// Throws Fault(invalid) in words where the change makes no sense: segments that are not there or removed
    /// twice, threads of no length, points that nothing would hold any more.
    virtual const WebAtRest& changed(const WebChange& change) = 0;

protected:
    ~WebDraft() = default;
};

/// Whoever writes in webs. A web asks once, before time starts, and is from then on as its draft was changed
/// last.
class Inscriber {
public:
    static constexpr const char* kContract = "inscriber/1";

    /// `threads` is the web itself as it moves, to be looked at once time runs. What the scene asks to be
    /// written and cannot be is a fault that the inscriber reports; the web is then plain, and nothing is run.
    virtual void inscribe(WebDraft& draft, const Threads& threads) = 0;
    /// Whether the draft is to live as long as the web: who studies ways of writing goes on to change it, to no
    /// effect on the web.
    virtual bool keeps_draft() const noexcept = 0;

protected:
    ~Inscriber() = default;
};

}  // namespace orbweaver
