#include "study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>

namespace orbweaver::study {

namespace {

std::vector<Vec3> mean_shape(const Motion& motion) {
    std::vector<Vec3> mean(motion.particles);
    for (std::size_t i = 0; i < motion.positions.size(); ++i) mean[i % motion.particles] += motion.positions[i];
    for (Vec3& place : mean) place = place / static_cast<double>(std::max<std::size_t>(1, motion.rows()));
    return mean;
}

double mean_square(const Motion& motion, std::size_t particle, const Vec3& mean) {
    double sum = 0;
    for (std::size_t i = 0; i < motion.rows(); ++i) {
        const Vec3 away = motion.row(i)[particle] - mean;
        sum += dot(away, away);
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, motion.rows()));
}

double power_at(std::span<const Vec3> samples, std::size_t k) {
    const auto n = static_cast<double>(samples.size());
    const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / n);
    std::complex<double> phase = 1;
    std::complex<double> x, y, z;
    for (const Vec3& sample : samples) {
        x += sample.x * phase;
        y += sample.y * phase;
        z += sample.z * phase;
        phase *= turn;
    }
    return std::norm(x) + std::norm(y) + std::norm(z);
}

double strongest_frequency(const Motion& motion, std::size_t particle, const Vec3& mean) {
    constexpr std::size_t kMostSamples = 4096;
    const std::size_t count = std::min(motion.rows(), kMostSamples);
    std::vector<Vec3> samples;
    for (std::size_t i = motion.rows() - count; i < motion.rows(); ++i)
        samples.push_back(motion.row(i)[particle] - mean);
    std::size_t strongest = 0;
    double most = 0;
    for (std::size_t k = 1; k <= count / 2; ++k)
        if (const double power = power_at(samples, k); power > most) {
            most = power;
            strongest = k;
        }
    return static_cast<double>(strongest) / (static_cast<double>(count) * motion.frame_s);
}

double relative(double found, double reference) {
    return found == reference ? 0 : std::abs(found - reference) / std::abs(reference);
}

}  // namespace

std::size_t busiest_particle(const Motion& motion) {
    const std::vector<Vec3> mean = mean_shape(motion);
    std::size_t busiest = 0;
    double most = -1;
    for (std::size_t i = 0; i < motion.particles; ++i)
        if (const double square = mean_square(motion, i, mean[i]); square > most) {
            most = square;
            busiest = i;
        }
    return busiest;
}

Statistics measure(const Motion& motion, std::size_t particle) {
    Statistics statistics;
    const auto& energy = motion.energy_j;
    statistics.mean_energy_j = energy.empty() ? std::numeric_limits<double>::quiet_NaN()
                                              : std::accumulate(energy.begin(), energy.end(), 0.0) /
                                                    static_cast<double>(energy.size());
    statistics.mean_shape = mean_shape(motion);
    statistics.power_m2 = mean_square(motion, particle, statistics.mean_shape[particle]);
    statistics.frequency_hz = strongest_frequency(motion, particle, statistics.mean_shape[particle]);
    return statistics;
}

Deviation compare(const Statistics& found, const Statistics& reference) {
    Deviation deviation;
    deviation.energy = relative(found.mean_energy_j, reference.mean_energy_j);
    for (std::size_t i = 0; i < reference.mean_shape.size(); ++i)
        deviation.shape_m = std::max(deviation.shape_m, distance(found.mean_shape[i], reference.mean_shape[i]));
    deviation.frequency = relative(found.frequency_hz, reference.frequency_hz);
    deviation.power = relative(found.power_m2, reference.power_m2);
    return deviation;
}

}  // namespace orbweaver::study
