#include "motion.hpp"

namespace orbweaver::spider {

MotionMethod find_motion_method(std::string_view name) noexcept {
    return name == "rk4"        ? MotionMethod::rk4
           : name == "midpoint" ? MotionMethod::midpoint
                                : MotionMethod::euler;
}

Motion moved(MotionMethod method, const Agent& agent, const Vec3& wanted, double response, double strength,
             double dt) noexcept {
    const auto control_after = [&](const Vec3& control, double time) {
        Agent then = agent;
        then.velocity += time * control;
        return spider::control(then, wanted, response, strength);
    };
    const auto after = [&](const Vec3& control, double time) { return accelerate(agent, control, time); };
    const Vec3 first = control_after({}, 0);
    if (method == MotionMethod::euler) return {after(first, dt), after(first, dt)};
    const Vec3 second = control_after(first, dt / 2);
    if (method == MotionMethod::midpoint) return {after(second, dt), after(first, dt / 2)};
    const Vec3 third = control_after(second, dt / 2), fourth = control_after(third, dt);
    return {after((first + 2 * second + 2 * third + fourth) / 6, dt), after((first + second + third) / 6, dt)};
}

}  // namespace orbweaver::spider
