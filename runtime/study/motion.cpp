#include "study/motion.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::study {

std::vector<double> distances(const Motion& a, const Motion& b) {
    std::vector<double> all(std::min(a.rows(), b.rows()));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = largest_distance(a.row(i), b.row(i));
    return all;
}

double distance(const Motion& a, const Motion& b, std::size_t rows) {
    const std::vector<double> all = distances(a, b);
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(rows, all.size()));
    return all.begin() == end ? 0 : *std::max_element(all.begin(), end);
}

double largest_displacement(const Motion& motion) {
    double largest = 0;
    for (std::size_t i = 1; i < motion.rows(); ++i)
        largest = std::max(largest, largest_distance(motion.row(i), motion.row(0)));
    return largest;
}

double rms_speed(const Motion& motion) {
    if (motion.rows() < 2) return 0;
    double sum = 0;
    for (std::size_t i = motion.particles; i < motion.positions.size(); ++i) {
        const Vec3 moved = motion.positions[i] - motion.positions[i - motion.particles];
        sum += dot(moved, moved);
    }
    return std::sqrt(sum / static_cast<double>(motion.positions.size() - motion.particles)) / motion.frame_s;
}

}  // namespace orbweaver::study
