#include "lanczos.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver::mass_spring {
namespace {

constexpr std::size_t kMaxSteps = 300;
constexpr std::size_t kStepsPerCheck = 5;

double dot_product(std::span<const Vec3> a, std::span<const Vec3> b) noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
    return sum;
}

/// The tridiagonal matrix of the iteration: off[i] couples i and i + 1, and its last entry the matrix to
/// what was left out.
struct Tridiagonal {
    std::vector<double> diagonal;
    std::vector<double> off;
    std::size_t size() const noexcept { return diagonal.size(); }
};

/// Whether every eigenvalue is below `shift`: all pivots of shift I - T are positive (Sturm).
bool all_below(const Tridiagonal& t, double shift) noexcept {
    double pivot = shift - t.diagonal[0];
    for (std::size_t i = 1; i < t.size() && pivot > 0; ++i) {
        pivot = shift - t.diagonal[i] - t.off[i - 1] * t.off[i - 1] / pivot;
    }
    return pivot > 0;
}

/// The least double-sized bracket's upper end: just above the largest eigenvalue.
double upper_eigenvalue(const Tridiagonal& t) noexcept {
    double low = t.diagonal[0];
    double high = low;
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double left = i > 0 ? t.off[i - 1] : 0;
        const double right = i + 1 < t.size() ? t.off[i] : 0;
        low = std::max(low, t.diagonal[i]);
        high = std::max(high, t.diagonal[i] + left + right);
    }
    high += 1e-12 * std::abs(high) + std::numeric_limits<double>::min();
    for (int i = 0; i < 100 && high - low > 1e-13 * std::abs(high); ++i) {
        const double middle = low + (high - low) / 2;
        (all_below(t, middle) ? high : low) = middle;
    }
    return high;
}

/// The eigenvector by inverse iteration on shift I - T, which is positive definite: no pivoting.
std::vector<double> eigenvector(const Tridiagonal& t, double shift) {
    const std::size_t n = t.size();
    std::vector<double> pivot(n);
    for (std::size_t i = 0; i < n; ++i) {
        pivot[i] = shift - t.diagonal[i] - (i > 0 ? t.off[i - 1] * t.off[i - 1] / pivot[i - 1] : 0);
    }
    std::vector<double> s(n, 1);
    for (int pass = 0; pass < 3; ++pass) {
        for (std::size_t i = 1; i < n; ++i) s[i] += t.off[i - 1] / pivot[i - 1] * s[i - 1];
        s[n - 1] /= pivot[n - 1];
        for (std::size_t i = n - 1; i-- > 0;) s[i] = (s[i] + t.off[i] * s[i + 1]) / pivot[i];
        double largest = 0;
        for (const double each : s) largest = std::max(largest, std::abs(each));
        double squares = 0;
        for (double& each : s) {
            each /= largest;
            squares += each * each;
        }
        for (double& each : s) each /= std::sqrt(squares);
    }
    return s;
}

/// The three-term recurrence, one step at a time; started anew it repeats itself bit by bit.
class Recurrence {
public:
    Recurrence(const SymmetricOperator& apply, std::span<const Vec3> start)
        : apply_(&apply), current_(start.begin(), start.end()), before_(start.size()), image_(start.size()) {
        const double length = std::sqrt(dot_product(current_, current_));
        if (length > 0) {
            for (Vec3& each : current_) each = each / length;
        }
    }

    std::span<const Vec3> current() const noexcept { return current_; }

    /// Appends one row to `t`; false when the space is exhausted and there is no next vector.
    bool step(Tridiagonal& t) {
        (*apply_)(current_, image_);
        const double diagonal = dot_product(current_, image_);
        const double back = t.off.empty() ? 0 : t.off.back();
        for (std::size_t i = 0; i < image_.size(); ++i) image_[i] -= diagonal * current_[i] + back * before_[i];
        const double off = std::sqrt(dot_product(image_, image_));
        t.diagonal.push_back(diagonal);
        t.off.push_back(off);
        scale_ = std::max({scale_, std::abs(diagonal), off});
        if (!(off > 1e-14 * scale_)) return false;
        for (std::size_t i = 0; i < image_.size(); ++i) {
            before_[i] = current_[i];
            current_[i] = image_[i] / off;
        }
        return true;
    }

private:
    const SymmetricOperator* apply_;
    std::vector<Vec3> current_, before_, image_;
    double scale_ = 0;
};

std::vector<Vec3> combine(const SymmetricOperator& apply, std::span<const Vec3> start,
                          std::span<const double> weights) {
    Recurrence recurrence(apply, start);
    Tridiagonal unused;
    std::vector<Vec3> sum(start.size());
    for (std::size_t j = 0; j < weights.size(); ++j) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weights[j] * recurrence.current()[i];
        if (j + 1 < weights.size()) recurrence.step(unused);
    }
    const double length = std::sqrt(dot_product(sum, sum));
    for (Vec3& each : sum) each = each / length;
    return sum;
}

}  // namespace

EigenPair largest_eigenpair(const SymmetricOperator& apply, std::span<const Vec3> start, double tolerance) {
    if (dot_product(start, start) == 0) return {};
    Recurrence recurrence(apply, start);
    Tridiagonal t;
    const std::size_t limit = std::min(kMaxSteps, 3 * start.size());
    // Where eigenvalues crowd, the vector goes on turning among them long after the value stands.
    constexpr std::size_t kStepsPerStand = 20, kFewest = 60;
    double stood = 0;
    for (;;) {
        const bool more = recurrence.step(t);
        const bool last = !more || t.size() >= limit;
        if (!last && t.size() % kStepsPerCheck != 0) continue;
        const double value = upper_eigenvalue(t);
        const double shift = value + 1e-12 * std::abs(value) + std::numeric_limits<double>::min();
        const std::vector<double> weights = eigenvector(t, shift);
        const double residual = t.off.back() * std::abs(weights.back());
        bool stands = false;
        if (t.size() % kStepsPerStand == 0) {
            stands = t.size() >= kFewest && value - stood <= tolerance * std::abs(value);
            stood = value;
        }
        if (last || stands || residual <= tolerance * std::abs(value))
            return {value, combine(apply, start, weights)};
    }
}

}  // namespace orbweaver::mass_spring
