#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// A point of a swing in its own plane: how far along it is, from 0 to 1, and how high, 0 at both ends and 1 at
/// the highest.
struct SwingPoint {
    double along = 0;
    double height = 0;
};

/// A form of swing: point(s) for s in [0, 1]; point(0) = (0, 0), point(1) = (1, 0).
struct StridePath {
    std::string_view name;  ///< as species write it
    SwingPoint (*point)(double progress) noexcept;
};

/// cycloid: (t - sin t)/(2 pi), (1 - cos t)/2 with t = 2 pi s, the path of a mark on a wheel's rim (K. Vasin,
/// Procedural spider animation): lands and lifts without speed. arc: a parabola, passed evenly. reach: up
/// first, then down from ahead. creep: highest late, and slow at both ends.
const StridePath* find_stride_path(std::string_view name) noexcept;
std::span<const StridePath> stride_paths() noexcept;

/// What a creature is about while its foot swings.
enum class Swinging : std::uint8_t { walks, runs, searches, stalks };
/// cycloid, arc, reach and creep.
const StridePath& path_of(Swinging what) noexcept;

/// A swing between two footholds over land.
struct Swing {
    Vec3 start, end;        ///< m
    Vec3 start_up, end_up;  ///< unit, away from the surface
    double height = 0;      ///< m, of the path above the line between its ends
};

/// Where the foot is (m). The path lies in the plane of the line from start to end and of the mean of both ups;
/// the land that it is laid over bends its height from one up to the other. Where ends meet, it goes up and
/// down; where the ups are opposite or along the line, it keeps to the line's side that start_up is on. Exact
/// at both ends, to the bit.
Vec3 foot_at(const StridePath& path, const Swing& swing, double progress) noexcept;

}  // namespace orbweaver::spider
