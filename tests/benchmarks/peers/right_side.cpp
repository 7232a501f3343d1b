#include "right_side.hpp"

#include <algorithm>
#include <span>

namespace orbweaver::peers {
namespace {

using mass_spring::Spring;

class PlainRightSide final : public RightSide {
public:
    explicit PlainRightSide(const Problem& problem) : problem_(&problem) {}

    std::string_view name() const noexcept override { return "plain"; }
    std::size_t length() const noexcept override { return 6 * problem_->network.size(); }

    void pack(const Problem& problem, double* y) const override {
        const std::span<const double> x = flat(std::span(problem.x)), v = flat(std::span(problem.v));
        std::copy(v.begin(), v.end(), std::copy(x.begin(), x.end(), y));
    }

    std::vector<Vec3> positions(const double* y) const override {
        const auto* x = reinterpret_cast<const Vec3*>(y);
        return {x, x + problem_->network.size()};
    }

    void evaluate(const double* y, double* rate) override {
        const mass_spring::Network& network = problem_->network;
        const std::size_t n = network.size();
        const auto* x = reinterpret_cast<const Vec3*>(y);
        const Vec3* v = x + n;
        auto* dx = reinterpret_cast<Vec3*>(rate);
        Vec3* a = dx + n;
        for (std::size_t i = 0; i < n; ++i) a[i] = {};
        for (const Spring& s : network.springs) {
            const Vec3 l = x[s.a] - x[s.b];
            const Vec3 dl = v[s.a] - v[s.b];
            const double length = norm(l);
            const Vec3 f =
                l * ((s.stiffness * (length - s.rest_length) + s.damping * dot(dl, l) / length) / length);
            a[s.a] -= f;
            a[s.b] += f;
        }
        for (std::size_t i = 0; i < n; ++i) {
            dx[i] = v[i];
            const Vec3 force = a[i] + problem_->wind[i] - problem_->drag * v[i];
            a[i] = network.fixed[i] != 0 ? Vec3{} : force / network.mass[i] + problem_->gravity;
        }
    }

private:
    const Problem* problem_;
};

class FastRightSide final : public RightSide {
public:
    explicit FastRightSide(const Problem& problem) : system_(problem.network, nullptr) {
        system_.set_surroundings(problem.surroundings());
    }

    std::string_view name() const noexcept override { return "orbweaver's"; }
    std::size_t length() const noexcept override { return 2 * system_.length(); }

    void pack(const Problem& problem, double* y) const override {
        std::fill(y, y + length(), 0.0);
        system_.packing().pack(problem.x, {y, system_.length()});
        system_.packing().pack(problem.v, {y + system_.length(), system_.length()});
    }

    std::vector<Vec3> positions(const double* y) const override {
        std::vector<Vec3> x(system_.size());
        system_.packing().unpack({y, system_.length()}, x);
        return x;
    }

    void evaluate(const double* y, double* rate) override {
        const std::size_t n = system_.length();
        std::copy(y + n, y + 2 * n, rate);
        system_.accelerations({y, n}, {y + n, n}, {rate + n, n});
    }

private:
    mass_spring::SpringSystem system_;
};

}  // namespace

std::unique_ptr<RightSide> make_plain_right_side(const Problem& problem) {
    return std::make_unique<PlainRightSide>(problem);
}

std::unique_ptr<RightSide> make_fast_right_side(const Problem& problem) {
    return std::make_unique<FastRightSide>(problem);
}

}  // namespace orbweaver::peers
