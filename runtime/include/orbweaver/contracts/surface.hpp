#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

inline constexpr std::uint32_t kNoFace = 0xFFFFFFFF;

/// How a query of the surface ended. Nothing is thrown.
enum class Answer : std::uint8_t {
    found,
    nothing,  ///< within the reach there is no surface
    refused,  ///< the question means nothing: not finite, no direction, no such face, a reach below 0
    failed,   ///< no memory for what the answer needs; who was asked stops the run with a sentence
};

/// From `origin` (m) along `direction` (any length but 0). Distances along it are multiples of the
/// direction's length: metres when it is a unit vector.
struct SurfaceRay {
    Vec3 origin;
    Vec3 direction;
    double reach = std::numeric_limits<double>::infinity();  ///< hits at distances in [0, reach] count
};

/// A place on a face: position = sum of weights[i] * corner i; weights are >= 0 and sum to 1.
struct SurfacePoint {
    std::uint32_t face = kNoFace;
    std::array<double, 3> weights{};
};

/// What a query found; Surface::position and Surface::normal tell the rest to who wants it.
struct SurfaceHit {
    Answer answer = Answer::nothing;
    SurfacePoint at;      ///< both faces of a triangle are hit
    double distance = 0;  ///< along a ray in its direction's lengths; else m
};

/// A body that wants to know the polygon under it.
struct Stance {
    Vec3 position;                 ///< m, the body's origin, above the surface
    Vec3 up;                       ///< unit, away from the surface
    Vec3 forward;                  ///< along the surface
    std::uint32_t last = kNoFace;  ///< the face that it was on when it last asked; kNoFace: unknown
    int side = 1;                  ///< of that face: 1 where its normal points, -1 its back
    /// m, how far below the surface may be: a little more than the height at which the body is carried. What
    /// lies deeper, beyond a thin wall or under a fold, is not underfoot.
    double reach = std::numeric_limits<double>::infinity();
};

/// What found the polygon, from the cheapest to the dearest.
enum class FoundBy : std::uint8_t { current, walk, rings, scan, tree };

struct Underfoot {
    SurfaceHit hit;
    FoundBy by = FoundBy::current;
};

/// Somebody who stands on a face, on the side that its normal points to (side = 1) or on its back (-1).
/// `position` and `up` follow from the rest; place() and step() fill them in.
struct Footing {
    SurfacePoint at;
    int side = 1;
    Vec3 forward;   ///< unit, in the plane of the face
    Vec3 position;  ///< m
    Vec3 up;        ///< unit, side * normal of the face
};

enum class StepStop : std::uint8_t {
    none,    ///< the whole length was walked
    border,  ///< an edge or vertex beyond which there is no surface
    limit,   ///< more crossings than a step may have: the length is absurd for this mesh
};

struct SurfaceStep {
    Answer answer = Answer::refused;
    StepStop stop = StepStop::none;
    Footing end;
    double walked = 0;            ///< m along the surface
    std::uint32_t crossings = 0;  ///< edges and vertices crossed
};

/// Where a stride passes from one face to another that is not in its plane.
struct StrideCorner {
    double distance = 0;  ///< m from the stride's beginning, along the surface
    Vec3 position;        ///< m
    Vec3 up_before;       ///< unit
    Vec3 up_after;        ///< unit
    bool rises = false;   ///< an inside corner (a wall ahead); false: an outside edge (a drop)
};

struct SurfaceStride {
    SurfaceStep step;
    std::uint32_t corners = 0;  ///< met; the first of them are in the span that was given
};

/// What one face is to walk on.
struct SurfaceGrip {
    double friction = 0;    ///< coefficient, 1
    bool climbable = true;  ///< false: glass; no creature holds on to it against gravity
};

/// Triangles to walk on; positions in metres, world frame, right-handed. They do not move. Every query is
/// a pure function of its arguments and may be asked from several threads.
class Surface {
public:
    static constexpr const char* kContract = "surface/1";

    virtual std::span<const Vec3> vertices() const noexcept = 0;
    virtual std::span<const std::array<std::uint32_t, 3>> faces() const noexcept = 0;
    /// The polygon of the source that each face is part of: the two halves of a quad share one.
    virtual std::span<const std::uint32_t> polygons() const noexcept = 0;
    virtual double size() const noexcept = 0;  ///< m, largest extent of the bounds
    virtual SurfaceGrip grip(std::uint32_t face) const noexcept = 0;
    /// m, where a place on one of the faces is.
    virtual Vec3 position(const SurfacePoint& at) const noexcept = 0;
    /// Unit, of the winding of one of the faces (counter-clockwise from where it points).
    virtual Vec3 normal(std::uint32_t face) const noexcept = 0;

    /// The nearest crossing of ray and surface.
    virtual SurfaceHit first_hit(const SurfaceRay& ray) const noexcept = 0;
    /// The point of the surface nearest to `point`, if within `reach` (m).
    virtual SurfaceHit closest_point(const Vec3& point, double reach) const noexcept = 0;

    /// The face below a body, cheapest way first: see modules/surface/README.md.
    virtual Underfoot underfoot(const Stance& stance) const noexcept = 0;

    /// Somebody at `at` whose up is nearest to `up`, facing as nearly along `forward` as the face allows.
    virtual SurfaceStep place(const SurfacePoint& at, const Vec3& up, const Vec3& forward) const noexcept = 0;
    /// Straight ahead along the surface by `length` (m, >= 0), over edges and vertices.
    virtual SurfaceStep step(const Footing& from, double length) const noexcept = 0;
    /// As step(), and on to whatever other shell of the surface stands in the way; tells of the corners met.
    virtual SurfaceStride stride(const Footing& from, double length,
                                 std::span<StrideCorner> corners) const noexcept = 0;

protected:
    ~Surface() = default;
};

}  // namespace orbweaver
