#include <array>

#include "builtin_methods.hpp"
#include "larger.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr std::size_t kStages = 7;
using Row = std::array<double, kStages>;
using Tableau = std::array<Row, kStages>;

// Ch. Tsitouras, Runge-Kutta pairs of order 5(4) satisfying only the first column simplifying assumption, 2011.
constexpr Tableau kA{{
    {},
    {0.161},
    {-0.008480655492356989, 0.335480655492357},
    {2.8971530571054935, -6.359448489975075, 4.3622954328695815},
    {5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525},
    {5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401, -0.028269050394068383},
    {0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081, 2.324710524099774},
}};
/// Weights of order five less those of order four.
constexpr Row kError{-0.00178001105222577714, -0.0008164344596567469, 0.007880878010261995, -0.1447110071732629,
                     0.5823571654525552,      -0.45808210592918697,   0.015151515151515152};

constexpr Row times(const Row& row, const Tableau& matrix) {
    Row product{};
    for (std::size_t i = 0; i < kStages; ++i)
        for (std::size_t j = 0; j < kStages; ++j) product[j] += row[i] * matrix[i][j];
    return product;
}

constexpr double sum(const Row& row) {
    double total = 0;
    for (const double each : row) total += each;
    return total;
}

/// Tsitouras' method of order five with an embedded one of order four. With x'' = a(x, v) the stages need no
/// velocities but the first: with the tableau A,
///     x_i = x + h (A 1)_i v + h^2 (A^2 a)_i,    v_i = v + h (A a)_i.
/// The last stage is where the step ends, and the next one's first.
class Tsit5 final : public Method {
public:
    explicit Tsit5(std::size_t length) : x_(length), v_(length) {
        for (auto& a : a_) a.resize(length);
    }

    void begin() noexcept override { has_slope_ = false; }

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        if (has_slope_)
            a_[0].swap(a_[kStages - 1]);
        else
            system.accelerations(x, v, a_[0]);
        stages(system, x, v, h, std::make_index_sequence<kStages - 2>{});
        stage<kStages - 1>(x, v, h, x.data(), v.data());
        system.accelerations(x, v, a_[kStages - 1]);
        has_slope_ = true;
        h_ = h;
    }

    double error(DynamicSystem&) override {
        static constexpr Row kErrorX = times(kError, kA);  // kError adds up to nothing: v falls out
        double largest = 0;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            double ex = 0;
            double ev = 0;
            for (std::size_t j = 0; j < kStages; ++j) {
                ex += kErrorX[j] * a_[j][i];
                ev += kError[j] * a_[j][i];
            }
            largest = larger(larger(largest, ex), ev);
        }
        return h_ * h_ * largest;
    }

    std::size_t memory_bytes() const noexcept override {
        return (kStages + 2) * x_.capacity() * sizeof(double);
    }

private:
    template <std::size_t... kIndices>
    void stages(DynamicSystem& system, std::span<const double> x, std::span<const double> v, double h,
                std::index_sequence<kIndices...>) {
        ((stage<kIndices + 1>(x, v, h, x_.data(), v_.data()), system.accelerations(x_, v_, a_[kIndices + 1])),
         ...);
    }

    template <std::size_t kStage>
    void stage(std::span<const double> x, std::span<const double> v, double h, double* xs,
               double* vs) noexcept {
        static constexpr Row kV = kA[kStage];
        static constexpr Row kX = times(kV, kA);
        static constexpr double kC = sum(kV);
        std::array<const double*, kStages> a;
        for (std::size_t j = 0; j < kStages; ++j) a[j] = a_[j].data();
        wide_loop(x.size(), [h, a, xs, vs, x = x.data(), v = v.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            double sum_x = 0;
            double sum_v = 0;
#pragma GCC unroll 7
            for (std::size_t j = 0; j < kStage; ++j) {
                sum_x += kX[j] * a[j][i];
                sum_v += kV[j] * a[j][i];
            }
            const double before = v[i];
            xs[i] = x[i] + h * (kC * before + h * sum_x);
            vs[i] = before + h * sum_v;
        });
    }

    std::vector<double> x_, v_;  ///< of a stage
    std::array<std::vector<double>, kStages> a_;
    double h_ = 0;
    bool has_slope_ = false;  ///< the last of a_ is that of the state the last step ended in
};

}  // namespace

std::unique_ptr<Method> make_tsit5(std::size_t length) { return std::make_unique<Tsit5>(length); }

}  // namespace orbweaver::mass_spring
