#include "fcl_clearance.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "fcl_mesh.hpp"

namespace orbweaver::surface {

namespace {

using Boxes = fcl::BVHModel<fcl::OBBRSS<double>>;
using Pose = fcl::Transform3d;

fcl::Vector3d scaled(const WideFrame& frame, const Vec3& p) noexcept {
    const Vec3 q = (p - frame.middle) / frame.size;
    return {q.x, q.y, q.z};
}

Vec3 unscaled(const WideFrame& frame, const fcl::Vector3d& p) noexcept {
    return frame.middle + frame.size * Vec3{p[0], p[1], p[2]};
}

/// The point of a body that is nearest to `p`. FCL gives a body's own nearest point in one frame for one pair
/// of shapes and in another for the next, so it is not asked for it.
Vec3 nearest_on(const ProbeBody& body, const Vec3& p) noexcept {
    const Vec3 from = p - body.center;
    const auto within = [&](const Vec3& axis, double half) {
        return std::clamp(dot(from, axis), -half, half) * axis;
    };
    if (body.shape == ProbeBody::Shape::box) {
        const auto& [x, y, z] = body.axes;
        return body.center + within(x, body.size.x / 2) + within(y, body.size.y / 2) +
               within(z, body.size.z / 2);
    }
    const bool round = body.shape == ProbeBody::Shape::sphere;
    const Vec3 core = body.center + (round ? Vec3{} : within(body.axes[2], body.size.z / 2));
    return core + body.size.x * unit(p - core);
}

/// A body as FCL has it, in a frame's units.
class ScaledBody {
public:
    ScaledBody(const WideFrame& frame, const ProbeBody& body) : shape_(shape_of(body, 1 / frame.size)) {
        pose_.setIdentity();
        pose_.translation() = scaled(frame, body.center);
        for (int i = 0; i < 3; ++i) {
            const Vec3& axis = body.axes[static_cast<std::size_t>(i)];
            pose_.linear().col(i) = fcl::Vector3d(axis.x, axis.y, axis.z);
        }
    }

    const fcl::CollisionGeometryd* shape() const {
        return std::visit([](const auto& each) -> const fcl::CollisionGeometryd* { return &each; }, shape_);
    }
    const Pose& pose() const { return pose_; }

private:
    using Shape = std::variant<fcl::Sphered, fcl::Capsuled, fcl::Boxd>;

    static Shape shape_of(const ProbeBody& body, double scale) {
        const Vec3 size = scale * body.size;
        if (body.shape == ProbeBody::Shape::sphere) return fcl::Sphered(size.x);
        if (body.shape == ProbeBody::Shape::capsule) return fcl::Capsuled(size.x, size.z);
        return fcl::Boxd(size.x, size.y, size.z);
    }

    Shape shape_;
    Pose pose_;
};

bool is_sound(const ProbeBody& body) noexcept {
    constexpr double kRounding = 1e-6;  // of axes that are unit and upright to each other
    const auto& [x, y, z] = body.axes;
    if (!is_finite(body.center) || !is_finite(x) || !is_finite(y) || !is_finite(z) || !is_finite(body.size))
        return false;
    if (norm(cross(x, y) - z) > kRounding || std::abs(dot(x, y)) > kRounding ||
        std::abs(norm(x) - 1) > kRounding)
        return false;
    if (body.shape == ProbeBody::Shape::sphere) return body.size.x > 0;
    if (body.shape == ProbeBody::Shape::capsule) return body.size.x > 0 && body.size.z >= 0;
    return body.size.x > 0 && body.size.y > 0 && body.size.z > 0;
}

double extent(const ProbeBody& body) noexcept { return std::max({body.size.x, body.size.y, body.size.z}); }

/// In the frame's units; both distances in m.
Clearance ask(const WideFrame& frame, const ScaledBody& body, const fcl::CollisionGeometryd* other,
              const Pose& pose, double reach) {
    fcl::DistanceRequestd request(true);
    constexpr double kTolerance = 1e-10;  // of the frame's size
    request.distance_tolerance = kTolerance;
    fcl::DistanceResultd result(std::min(reach / frame.size, std::numeric_limits<double>::max()));
    fcl::distance(other, pose, body.shape(), body.pose(), request, result);
    if (result.o1 == nullptr) return {};
    Clearance clearance;
    clearance.answer = Answer::found;
    if (!(result.min_distance > 0)) return clearance;
    clearance.distance = result.min_distance * frame.size;
    clearance.on_other = unscaled(frame, result.nearest_points[0]);
    return clearance;
}

Clearance answer(Answer kind) noexcept {
    Clearance clearance;
    clearance.answer = kind;
    return clearance;
}

}  // namespace

struct FclClearance::Model {
    Boxes boxes;
};

FclClearance::FclClearance(const TriangleSet& set) : frame_(frame_of(set)), model_(std::make_unique<Model>()) {
    std::vector<Vec3> vertices;
    vertices.reserve(set.vertices.size());
    for (const Vec3& v : set.vertices) vertices.push_back((v - frame_.middle) / frame_.size);
    build_model(model_->boxes, {vertices, set.triangles});
}

FclClearance::~FclClearance() = default;

Clearance FclClearance::clearance(const ProbeBody& body, double reach) const noexcept try {
    if (!is_sound(body) || !(reach >= 0)) return answer(Answer::refused);
    Clearance found = ask(frame_, ScaledBody(frame_, body), &model_->boxes, Pose::Identity(), reach);
    if (found.distance > 0) found.on_body = nearest_on(body, found.on_other);
    return found;
} catch (const std::exception&) {
    return answer(Answer::failed);
}

std::size_t FclClearance::memory_bytes() const noexcept { return model_bytes(model_->boxes); }

Clearance body_clearance(const ProbeBody& body, const ProbeBody& other) noexcept try {
    if (!is_sound(body) || !is_sound(other)) return answer(Answer::refused);
    const WideFrame frame{body.center, std::max(extent(body), extent(other))};
    const ScaledBody second(frame, other);
    Clearance found = ask(frame, ScaledBody(frame, body), second.shape(), second.pose(),
                          std::numeric_limits<double>::infinity());
    if (found.distance > 0) found.on_body = nearest_on(body, found.on_other);
    return found;
} catch (const std::exception&) {
    return answer(Answer::failed);
}

}  // namespace orbweaver::surface
