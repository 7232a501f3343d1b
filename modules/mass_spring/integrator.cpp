#include "integrator.hpp"

#include <algorithm>
#include <cmath>

#include "step_control.hpp"

namespace orbweaver::mass_spring {

Integrator::Integrator(SpringSystem& system, const MethodInfo& method)
    : system_(&system),
      info_(&method),
      method_(method.make(system.length())),
      x_(system.length()),
      v_(system.length()) {}

void Integrator::pack(std::span<const Vec3> x, std::span<const Vec3> v) {
    system_->packing().pack(x, x_);
    system_->packing().pack(v, v_);
    method_->begin();
}

void Integrator::unpack(std::span<Vec3> x, std::span<Vec3> v) const {
    system_->packing().unpack(x_, x);
    system_->packing().unpack(v_, v);
}

void Integrator::advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count) {
    pack(x, v);
    const bool creeps = system_->creep_count() > 0;
    if (creeps) system_->creep(x_, h / 2);
    for (std::int64_t i = 0; i < count; ++i) {
        method_->step(*system_, x_, v_, h);
        if (!creeps) continue;
        system_->creep(x_, i + 1 < count ? h : h / 2);
        method_->begin();
    }
    unpack(x, v);
}

ControlledRun Integrator::advance_within(std::span<Vec3> x, std::span<Vec3> v, double span, double tolerance,
                                         double first, std::int64_t most_steps) {
    constexpr double kShortest = 1e-12;  // of the span
    constexpr std::int64_t kPatience =
        10;  // steps without growth: where stability rules, it would be refused again
    // A hundredth of the steps that gets less than a thousandth of the way will not be made up for.
    constexpr std::int64_t kFewest = 1000;
    const std::int64_t pace = std::max(kFewest, most_steps / 100);
    const double least_way = span * static_cast<double>(pace) / static_cast<double>(most_steps) / 10;
    const StepControl control(info_->embedded_order, tolerance);
    ControlledRun run;
    run.next = first;
    pack(x, v);
    double left = span;
    double left_at_look = span;
    double count = 0, h = 0;            // of the equal steps that what is left is cut into
    std::int64_t refused = -kPatience;  // the last step that was
    while (run.steps < most_steps && run.next > kShortest * span) {
        // What is left in equal steps, so that none is a crumb; cut anew only where the step is to be another,
        // or rounding would change it a little every time and no method could go on with the matrix it has.
        if (count == 0) {
            count = std::max(1.0, std::ceil(left / run.next * (1 - 1e-9)));
            h = left / count;
        }
        start_x_ = x_;
        start_v_ = v_;
        method_->step(*system_, x_, v_, h);
        ++run.steps;
        if (run.steps % pace == 0) {
            if (left_at_look - left < least_way) break;
            left_at_look = left;
        }
        const double error = method_->error(*system_);
        const double wish = control.scale(error);
        const double scale = run.steps - refused > kPatience ? wish : std::min(1.0, wish);
        run.next = std::min(span, scale == 1 ? std::max(h, run.next) : scale * h);
        if (!control.accepts(error)) {
            x_ = start_x_;
            v_ = start_v_;
            method_->begin();
            refused = run.steps;
            count = 0;
            continue;
        }
        run.error += error;
        left = count == 1 ? 0 : left - h;
        count = scale == 1 ? count - 1 : 0;
        if (left == 0) {
            run.finished = true;
            break;
        }
    }
    unpack(x, v);
    return run;
}

int Integrator::order() const noexcept {
    constexpr int kSplit = 2;
    return system_->creep_count() > 0 ? std::min(info_->order, kSplit) : info_->order;
}

std::size_t Integrator::memory_bytes() const noexcept {
    return method_->memory_bytes() +
           (x_.capacity() + v_.capacity() + start_x_.capacity() + start_v_.capacity()) * sizeof(double);
}

}  // namespace orbweaver::mass_spring
