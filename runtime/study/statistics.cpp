#include "study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>

namespace orbweaver::study {

namespace {

std::vector<Vec3> mean_shape(const Motion& motion, std::size_t first) {
    std::vector<Vec3> mean(motion.particles);
    for (std::size_t i = first * motion.particles; i < motion.positions.size(); ++i)
        mean[i % motion.particles] += motion.positions[i];
    for (Vec3& place : mean) place = place / static_cast<double>(motion.rows() - first);
    return mean;
}

double mean_square(const Motion& motion, std::size_t particle, const Vec3& mean, std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < motion.rows(); ++i) {
        const Vec3 away = motion.row(i)[particle] - mean;
        sum += dot(away, away);
    }
    return sum / static_cast<double>(motion.rows() - first);
}

/// Of the frames that end in row `first` or later.
double mean_energy(const std::vector<double>& energy, std::size_t first) {
    const std::size_t begin = first > 0 ? first - 1 : 0;
    if (begin >= energy.size()) return std::numeric_limits<double>::quiet_NaN();
    return std::accumulate(energy.begin() + static_cast<std::ptrdiff_t>(begin), energy.end(), 0.0) /
           static_cast<double>(energy.size() - begin);
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

std::vector<Vec3> samples_of(const Motion& motion, std::size_t particle, const Vec3& mean, std::size_t first) {
    constexpr std::size_t kMostSamples = 4096;
    std::vector<Vec3> samples;
    for (std::size_t i = motion.rows() - std::min(motion.rows() - first, kMostSamples); i < motion.rows(); ++i)
        samples.push_back(motion.row(i)[particle] - mean);
    return samples;
}

/// Power at 1, 2, ... times the lowest frequency, as shares of the whole; all 0 where nothing moves.
std::vector<double> spectrum_of(std::span<const Vec3> samples) {
    std::vector<double> powers;
    for (std::size_t k = 1; k <= samples.size() / 2; ++k) powers.push_back(power_at(samples, k));
    const double whole = std::accumulate(powers.begin(), powers.end(), 0.0);
    if (whole > 0)
        for (double& power : powers) power /= whole;
    return powers;
}

double strongest_frequency(const std::vector<double>& spectrum, std::size_t samples, double frame_s) {
    const auto strongest = std::max_element(spectrum.begin(), spectrum.end());
    if (strongest == spectrum.end() || *strongest == 0) return 0;
    return static_cast<double>(strongest - spectrum.begin() + 1) / (static_cast<double>(samples) * frame_s);
}

double distance_of_spectra(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) sum += std::abs(a[k] - b[k]);
    const auto still = [](const std::vector<double>& s) {
        return std::all_of(s.begin(), s.end(), [](double share) { return share == 0; });
    };
    return still(a) != still(b) ? 1 : sum / 2;  // all of the power that only one has
}

double relative(double found, double reference) {
    return found == reference ? 0 : std::abs(found - reference) / std::abs(reference);
}

}  // namespace

std::size_t busiest_particle(const Motion& motion, std::size_t first) {
    const std::vector<Vec3> mean = mean_shape(motion, first);
    std::size_t busiest = 0;
    double most = -1;
    for (std::size_t i = 0; i < motion.particles; ++i)
        if (const double square = mean_square(motion, i, mean[i], first); square > most) {
            most = square;
            busiest = i;
        }
    return busiest;
}

Statistics measure(const Motion& motion, std::size_t particle, std::size_t first) {
    Statistics statistics;
    statistics.mean_energy_j = mean_energy(motion.energy_j, first);
    statistics.mean_shape = mean_shape(motion, first);
    const Vec3& mean = statistics.mean_shape[particle];
    statistics.power_m2 = mean_square(motion, particle, mean, first);
    const auto samples = samples_of(motion, particle, mean, first);
    statistics.spectrum = spectrum_of(samples);
    statistics.frequency_hz = strongest_frequency(statistics.spectrum, samples.size(), motion.frame_s);
    return statistics;
}

Deviation compare(const Statistics& found, const Statistics& reference) {
    Deviation deviation;
    deviation.energy = relative(found.mean_energy_j, reference.mean_energy_j);
    for (std::size_t i = 0; i < reference.mean_shape.size(); ++i)
        deviation.shape_m = std::max(deviation.shape_m, distance(found.mean_shape[i], reference.mean_shape[i]));
    deviation.spectrum = distance_of_spectra(found.spectrum, reference.spectrum);
    deviation.frequency = relative(found.frequency_hz, reference.frequency_hz);
    deviation.power = relative(found.power_m2, reference.power_m2);
    return deviation;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace orbweaver::study
