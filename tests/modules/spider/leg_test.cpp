#include "leg.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

/// Bones of 1 to 6 mm, joints that turn all the way.
Leg sample_leg() {
    std::array<JointRange, kJoints> joints;
    joints.fill({-3, 3, -1, 1, 0.5, 0});
    joints[kTilt] = {-1.3, 1.3, -0.5, 0.5, 0.5, 0};
    return make_leg({0.001, 0.002, 0.003, 0.004, 0.005, 0.006}, joints);
}

struct Quaternion {
    double w, x, y, z;
};

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion about(const Vec3& axis, double angle) {
    const double s = std::sin(angle / 2);
    return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
    const double angle = std::acos(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z);
    const double p = std::sin((1 - t) * angle) / std::sin(angle), q = std::sin(t * angle) / std::sin(angle);
    return {p * a.w + q * b.w, p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
}

Vec3 turned(const Quaternion& q, const Vec3& v) {
    const Quaternion r = q * Quaternion{0, v.x, v.y, v.z} * Quaternion{q.w, -q.x, -q.y, -q.z};
    return {r.x, r.y, r.z};
}

}  // namespace

TEST_CASE("a straight leg points along its heading, yawed and pitched as a ray from the root", "[unit]") {
    const Leg leg = sample_leg();
    CHECK(leg.length == Approx(0.021));
    CHECK(distance(foot_position(leg, {}), {0.021, 0, 0}) < 1e-17);
    const double yaw = 0.7, pitch = -0.4;
    const Vec3 ray{std::cos(pitch) * std::cos(yaw), std::sin(pitch), -std::cos(pitch) * std::sin(yaw)};
    CHECK(distance(foot_position(leg, {yaw, 0, pitch}), 0.021 * ray) < 1e-16);
    CHECK(distance(foot_frame(leg, {yaw, 0, pitch}).x, ray) < 1e-15);
}

TEST_CASE("bones in their plane follow the sums of their angles", "[unit]") {
    const Leg leg = sample_leg();
    LegalPoses poses(leg);
    for (int round = 0; round < 1000; ++round) {
        const LegPose pose = poses.next();
        const auto joints = joint_positions(leg, pose);
        // By matrices from std::sin and std::cos.
        const double cy = std::cos(pose[kYaw]), sy = std::sin(pose[kYaw]);
        const double ct = std::cos(pose[kTilt]), st = std::sin(pose[kTilt]);
        Vec3 expected;
        double angle = 0;
        for (std::size_t i = 0; i < kBones; ++i) {
            CHECK(distance(joints[i], expected) < 1e-16);
            angle += pose[kPitch + i];
            const double u = std::cos(angle), v = std::sin(angle);
            expected +=
                0.001 * static_cast<double>(i + 1) * Vec3{cy * u + sy * st * v, ct * v, cy * st * v - sy * u};
        }
        CHECK(distance(joints[kBones], expected) < 1e-16);
        CHECK(distance(foot_position(leg, pose), joints[kBones]) < 1e-17);
    }
}

TEST_CASE("yaw and pitch are the rectangle that four quaternions at its corners span", "[unit]") {
    // ap Cenydd and Teahan (2005), 4.1: rectangular SLERP between the limits of a joint.
    const double yaw_min = -0.9, yaw_max = 0.6, pitch_min = -0.5, pitch_max = 1.1;
    for (const double tilt : {-0.6, 0.0, 0.8}) {
        const auto corner = [&](double yaw, double pitch) {
            return about({0, 1, 0}, yaw) * about({1, 0, 0}, tilt) * about({0, 0, 1}, pitch);
        };
        for (const double s : {0.05, 0.3, 0.5, 0.9})
            for (const double t : {0.1, 0.45, 0.7, 0.95}) {
                const Quaternion low = slerp(corner(yaw_min, pitch_min), corner(yaw_max, pitch_min), s);
                const Quaternion high = slerp(corner(yaw_min, pitch_max), corner(yaw_max, pitch_max), s);
                const Quaternion ball = slerp(low, high, t);
                const LegPose pose{yaw_min + s * (yaw_max - yaw_min), tilt,
                                   pitch_min + t * (pitch_max - pitch_min)};
                const Frame frame = foot_frame(sample_leg(), pose);
                CHECK(distance(turned(ball, {1, 0, 0}), frame.x) < 1e-14);
                CHECK(distance(turned(ball, {0, 1, 0}), frame.y) < 1e-14);
                CHECK(distance(turned(ball, {0, 0, 1}), frame.z) < 1e-14);
            }
    }
}

TEST_CASE("the Jacobian is what differences of positions and frames say", "[unit]") {
    const Leg leg = sample_leg();
    LegalPoses poses(leg);
    const double h = 1e-5;  // errors h^2 of the motion and 1e-16 / h of rounding: some 1e-10 of either
    for (int round = 0; round < 200; ++round) {
        const LegPose pose = poses.next();
        const Jacobian columns = jacobian(leg, pose);
        for (std::size_t j = 0; j < kJoints; ++j) {
            LegPose less = pose, more = pose;
            less[j] -= h;
            more[j] += h;
            const Vec3 move = (foot_position(leg, more) - foot_position(leg, less)) / (2 * h);
            CHECK(distance(move, columns[j].move) < 1e-9 * leg.length);
            const Frame before = foot_frame(leg, less), after = foot_frame(leg, more),
                        at = foot_frame(leg, pose);
            CHECK(distance((after.x - before.x) / (2 * h), cross(columns[j].axis, at.x)) < 1e-9);
            CHECK(distance((after.y - before.y) / (2 * h), cross(columns[j].axis, at.y)) < 1e-9);
        }
    }
}

TEST_CASE("a bone that a leg lacks changes nothing, and its joint does not turn", "[unit]") {
    std::array<JointRange, kJoints> joints;
    joints.fill({-1, 1, -0.5, 0.5, 0.5, 0.25});
    joints[4] = joints[6] = {};
    const Leg leg = make_leg({0.01, 0.02, 0, 0.03, 0, 0.01}, joints);
    LegalPoses poses(leg);
    for (int round = 0; round < 100; ++round) {
        const LegPose pose = poses.next();
        CHECK(pose[4] == 0);
        CHECK(pose[6] == 0);
        const auto positions = joint_positions(leg, pose);
        CHECK(positions[2] == positions[3]);
        CHECK(positions[4] == positions[5]);
    }
}

TEST_CASE("poses are moved into limits, and how far they were past them is told", "[unit]") {
    const Leg leg = sample_leg();
    LegPose pose{0, 0, 0, 3.1, -3.05};
    CHECK(violation(leg, pose) == Approx(0.1));
    pose = within_limits(leg, pose);
    CHECK(pose == LegPose{0, 0, 0, 3, -3});
    CHECK(violation(leg, pose) == 0);
}
