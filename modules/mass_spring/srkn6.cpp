#include <algorithm>
#include <array>

#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {
namespace {

// S. Blanes, P. C. Moan, Practical symplectic partitioned Runge-Kutta and Runge-Kutta-Nystrom methods, J.
// Comput. Appl. Math. 142 (2002): SRKN 11 b, of order six. Both rows read the same from either end.
constexpr std::size_t kStages = 11;
constexpr std::array<double, 6> kHalfOfKicks{0.0414649985182624, 0.198128671918067,   -0.0400061921041533,
                                             0.0752539843015807, -0.0115113874206879, 0};
constexpr std::array<double, 6> kHalfOfDrifts{0.123229775946271,  0.290553797799558, -0.127049212625417,
                                              -0.246331761062075, 0.357208872795928, 0};

/// The last of half a row is what makes the whole row add up to 1: all of what is missing where the row has a
/// middle, half of it where it has not.
template <std::size_t length>
constexpr std::array<double, length> whole_row(std::array<double, 6> half) {
    double sum = 0;
    for (const double each : half) sum += each;
    half.back() = length % 2 == 1 ? 1 - 2 * sum : 0.5 - sum;
    std::array<double, length> row{};
    for (std::size_t i = 0; i < length; ++i) row[i] = half[std::min(i, length - 1 - i)];
    return row;
}

constexpr auto kKicks = whole_row<kStages + 1>(kHalfOfKicks);
constexpr auto kDrifts = whole_row<kStages>(kHalfOfDrifts);

/// A symplectic Runge-Kutta-Nystrom method of order six: kicks v += b_j h a(x) and drifts x += a_j h v in turn.
/// What damps is drag alone, and acts in the drifts, where it is worked off as it is; kicks, by positions
/// alone, still give all that the order rests on.
class Srkn6 final : public Method {
public:
    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        for (std::size_t i = 0; i < kStages; ++i) system.kick_and_drift(x, v, kKicks[i] * h, kDrifts[i] * h);
        system.kick_and_drift(x, v, kKicks[kStages] * h, 0);
    }

    std::size_t memory_bytes() const noexcept override { return 0; }
};

}  // namespace

std::unique_ptr<Method> make_srkn6(std::size_t) { return std::make_unique<Srkn6>(); }

}  // namespace orbweaver::mass_spring
