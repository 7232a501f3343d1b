#include "sky_light.hpp"

namespace orbweaver::view {

SkyLight sky_light(const CubeSky& sky) {
    SkyLight light{};
    for (std::size_t f = 0; f < kFaces; ++f) {
        std::array<double, 3> sum{};
        const auto& face = sky.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i) sum[i % 3] += face[i];
        for (std::size_t c = 0; c < 3; ++c)
            light[f][c] = static_cast<float>(sum[c] / (static_cast<double>(face.size()) / 3));
    }
    return light;
}

KeyLight key_light(const CubeSky& sky) {
    KeyLight key;
    Vec3 sum;
    std::array<double, 3> light{};
    double weights = 0;
    const auto n = static_cast<std::size_t>(sky.size);
    for (std::size_t f = 0; f < kFaces; ++f)
        for (std::size_t i = 0; i < n * n; ++i) {
            const std::size_t row = i / n, column = i % n;
            const float* rgb = &sky.faces[f][3 * i];
            const double mean = (rgb[0] + rgb[1] + rgb[2]) / 3.0;
            const double s = (static_cast<double>(column) + 0.5) / sky.size;
            const double t = (static_cast<double>(row) + 0.5) / sky.size;
            const Vec3 way = face_direction(static_cast<Face>(f), s, t);
            const double length = norm(way);  // a pixel's solid angle goes as its inverse cube
            const double weight = mean * mean * mean * mean / (length * length * length);
            sum += weight / length * way;
            for (std::size_t c = 0; c < 3; ++c) light[c] += weight * rgb[c];
            weights += weight;
        }
    const double length = norm(sum);
    if (length > 1e-9 * weights) key.direction = sum / length;
    if (weights > 0)
        for (std::size_t c = 0; c < 3; ++c) key.light[c] = static_cast<float>(light[c] / weights);
    return key;
}

}  // namespace orbweaver::view
