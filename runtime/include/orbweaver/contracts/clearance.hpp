#pragma once

#include <array>
#include <cstdint>

#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A rounded or boxed body, for keeping clear of the surface and of other bodies.
struct ProbeBody {
    enum class Shape : std::uint8_t { sphere, capsule, box } shape = Shape::sphere;
    Vec3 center;  ///< m
    std::array<Vec3, 3> axes = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< unit, right-handed; a capsule's is the last
    Vec3 size;  ///< m; sphere: radius in x; capsule: radius in x, length between its ends' centers in z; box:
                ///< edges
};

struct Clearance {
    Answer answer = Answer::nothing;
    double distance = 0;  ///< m; 0 when they touch or overlap
    Vec3 on_body;         ///< m, nearest point of the body; only when distance > 0
    Vec3 on_other;        ///< m, nearest point of the surface or of the other body; only when distance > 0
};

/// How far bodies are from the scene's surface and from each other. Every query is a pure function of its
/// arguments and may be asked from several threads.
class Clearances {
public:
    static constexpr const char* kContract = "clearance/1";

    /// How far a body is from the surface, if within `reach` (m).
    virtual Clearance clearance(const ProbeBody& body, double reach) const noexcept = 0;
    /// How far two bodies are from each other.
    virtual Clearance clearance(const ProbeBody& body, const ProbeBody& other) const noexcept = 0;

protected:
    ~Clearances() = default;
};

}  // namespace orbweaver
