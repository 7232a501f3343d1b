#include "conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace orbweaver::mass_spring {
namespace {

Vec3 times(const SymmetricBlock& b, const Vec3& u) noexcept {
    return {b.xx * u.x + b.xy * u.y + b.xz * u.z, b.xy * u.x + b.yy * u.y + b.yz * u.z,
            b.xz * u.x + b.yz * u.y + b.zz * u.z};
}

double dot(std::span<const Vec3> a, std::span<const Vec3> b) noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += orbweaver::dot(a[i], b[i]);
    return sum;
}

/// By cofactors; nothing where a leading minor is not positive.
std::optional<SymmetricBlock> invert(const SymmetricBlock& b) noexcept {
    const double cx = b.yy * b.zz - b.yz * b.yz;
    const double cy = b.xz * b.yz - b.xy * b.zz;
    const double cz = b.xy * b.yz - b.xz * b.yy;
    const double determinant = b.xx * cx + b.xy * cy + b.xz * cz;
    const double minor = b.xx * b.yy - b.xy * b.xy;
    if (!(b.xx > 0) || !(minor > 0) || !(determinant > 0) || !std::isfinite(determinant)) return std::nullopt;
    const double s = 1 / determinant;
    return SymmetricBlock{
        s * cx, s * cy, s * cz, s * (b.xx * b.zz - b.xz * b.xz), s * (b.xy * b.xz - b.xx * b.yz), s * minor};
}

}  // namespace

ConjugateGradients::ConjugateGradients(const Network& network)
    : network_(&network),
      diagonal_(network.size()),
      blocks_(network.springs.size()),
      inverse_(network.size()),
      residual_(network.size()),
      step_(network.size()),
      preconditioned_(network.size()),
      image_(network.size()) {}

bool ConjugateGradients::factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) {
    std::copy(diagonal.begin(), diagonal.end(), diagonal_.begin());
    std::copy(blocks.begin(), blocks.end(), blocks_.begin());
    for (std::size_t i = 0; i < inverse_.size(); ++i)
        inverse_[i] = {diagonal[i], 0, 0, diagonal[i], 0, diagonal[i]};
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Spring& s = network_->springs[i];
        inverse_[s.a] = inverse_[s.a] + blocks[i];
        inverse_[s.b] = inverse_[s.b] + blocks[i];
    }
    for (std::size_t i = 0; i < inverse_.size(); ++i) {
        if (network_->fixed[i] != 0) continue;
        const auto inverse = invert(inverse_[i]);
        if (!inverse) return false;
        inverse_[i] = *inverse;
    }
    return true;
}

void ConjugateGradients::apply(std::span<const Vec3> in, std::span<Vec3> out) const noexcept {
    for (std::size_t i = 0; i < in.size(); ++i) out[i] = diagonal_[i] * in[i];
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Spring& s = network_->springs[i];
        const Vec3 pull = times(blocks_[i], in[s.a] - in[s.b]);
        out[s.a] += pull;
        out[s.b] -= pull;
    }
    for (std::size_t i = 0; i < in.size(); ++i)
        if (network_->fixed[i] != 0) out[i] = {};
}

void ConjugateGradients::precondition(std::span<const Vec3> in, std::span<Vec3> out) const noexcept {
    for (std::size_t i = 0; i < in.size(); ++i)
        out[i] = network_->fixed[i] != 0 ? Vec3{} : times(inverse_[i], in[i]);
}

bool ConjugateGradients::iterate(std::span<const Vec3> b, std::span<Vec3> u) {
    constexpr std::size_t kMost = 5000;
    constexpr double kTolerance = 1e-10;
    std::fill(u.begin(), u.end(), Vec3{});
    for (std::size_t i = 0; i < b.size(); ++i) residual_[i] = network_->fixed[i] != 0 ? Vec3{} : b[i];
    precondition(residual_, preconditioned_);
    std::copy(preconditioned_.begin(), preconditioned_.end(), step_.begin());
    double energy = dot(residual_, preconditioned_);
    const double enough = kTolerance * kTolerance * energy;
    for (iterations_ = 0; energy > enough; ++iterations_) {
        apply(step_, image_);
        const double curvature = dot(step_, image_);
        if (!(curvature > 0) || iterations_ == kMost) return false;
        const double way = energy / curvature;
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] += way * step_[i];
            residual_[i] -= way * image_[i];
        }
        precondition(residual_, preconditioned_);
        const double before = energy;
        energy = dot(residual_, preconditioned_);
        for (std::size_t i = 0; i < u.size(); ++i) step_[i] = preconditioned_[i] + (energy / before) * step_[i];
    }
    return std::isfinite(energy);
}

void ConjugateGradients::solve(std::span<const Vec3> b, std::span<Vec3> u) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (!iterate(b, u)) std::fill(u.begin(), u.end(), Vec3{kNone, kNone, kNone});
}

double ConjugateGradients::factorize_seconds() const noexcept {
    constexpr double kSpring = 10e-9, kParticle = 20e-9;
    return kSpring * static_cast<double>(blocks_.size()) + kParticle * static_cast<double>(diagonal_.size());
}

double ConjugateGradients::solve_seconds() const noexcept {
    constexpr double kSpring = 8e-9, kParticle = 12e-9;
    return static_cast<double>(iterations_ + 1) *
           (kSpring * static_cast<double>(blocks_.size()) + kParticle * static_cast<double>(diagonal_.size()));
}

std::size_t ConjugateGradients::memory_bytes() const noexcept {
    return diagonal_.size() * (sizeof(double) + sizeof(SymmetricBlock) + 4 * sizeof(Vec3)) +
           blocks_.size() * sizeof(SymmetricBlock);
}

}  // namespace orbweaver::mass_spring
