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

void Integrator::begin(std::span<const Vec3> x, std::span<const Vec3> v, StepBudget& budget) {
    system_->packing().pack(x, x_);
    system_->packing().pack(v, v_);
    method_->begin();
    method_->use_budget(&budget);
}

void Integrator::end(std::span<Vec3> x, std::span<Vec3> v) {
    method_->use_budget(nullptr);
    system_->packing().unpack(x_, x);
    system_->packing().unpack(v_, v);
}

void Integrator::advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count) {
    StepBudget endless;
    advance(x, v, h, count, endless);
}

bool Integrator::advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count,
                         StepBudget& budget) {
    begin(x, v, budget);
    const bool creeps = system_->creep_count() > 0;
    StepHooks* hooks = system_->hooks();
    if (creeps) system_->creep(x_, h / 2);
    for (std::int64_t i = 0; i < count && budget.take(); ++i) {
        if (hooks != nullptr) hooks->before_step(x_, v_, h);
        method_->step(*system_, x_, v_, h);
        if (hooks != nullptr) hooks->after_step(x_, v_, h);
        if (creeps) system_->creep(x_, i + 1 < count ? h : h / 2);
        if (creeps || hooks != nullptr) method_->begin();
    }
    end(x, v);
    return !budget.refused();
}

ControlledRun Integrator::advance_within(std::span<Vec3> x, std::span<Vec3> v, double span, double tolerance,
                                         double first, StepBudget budget) {
    constexpr double kShortest = 1e-12;  // of the span
    constexpr std::int64_t kPatience =
        10;  // steps without growth: where stability rules, it would be refused again
    // A hundredth of the steps that gets less than a thousandth of the way will not be made up for.
    constexpr std::int64_t kFewest = 1000;
    const std::int64_t pace = std::max(kFewest, budget.most() / 100);
    const double least_way = span * static_cast<double>(pace) / static_cast<double>(budget.most()) / 10;
    const StepControl control(info_->embedded_order, tolerance);
    ControlledRun run;
    run.next = first;
    begin(x, v, budget);
    double left = span;
    double left_at_look = span;
    double count = 0, h = 0;            // of the equal steps that what is left is cut into
    std::int64_t refused = -kPatience;  // the last step that was
    std::int64_t tried = 0;
    while (run.next > kShortest * span && budget.take()) {
        // What is left in equal steps, so that none is a crumb; cut anew only where the step is to be another,
        // or rounding would change it a little every time and no method could go on with the matrix it has.
        if (count == 0) {
            count = std::max(1.0, std::ceil(left / run.next * (1 - 1e-9)));
            h = left / count;
        }
        start_x_ = x_;
        start_v_ = v_;
        method_->step(*system_, x_, v_, h);
        ++tried;
        if (tried % pace == 0) {
            if (left_at_look - left < least_way) break;
            left_at_look = left;
        }
        const double error = method_->error(*system_);
        const double wish = control.scale(error);
        const double scale = tried - refused > kPatience ? wish : std::min(1.0, wish);
        run.next = std::min(span, scale == 1 ? std::max(h, run.next) : scale * h);
        if (!control.accepts(error)) {
            x_ = start_x_;
            v_ = start_v_;
            method_->begin();
            refused = tried;
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
    end(x, v);
    run.steps = budget.taken();
    run.stopped = budget.stopped();
    return run;
}

int Integrator::order() const noexcept {
    constexpr int kSplit = 2, kContact = 1;
    if (system_->hooks() != nullptr) return std::min(info_->order, kContact);
    return system_->creep_count() > 0 ? std::min(info_->order, kSplit) : info_->order;
}

std::size_t Integrator::memory_bytes() const noexcept {
    return method_->memory_bytes() +
           (x_.capacity() + v_.capacity() + start_x_.capacity() + start_v_.capacity()) * sizeof(double);
}

}  // namespace orbweaver::mass_spring
