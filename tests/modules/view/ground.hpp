#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "build.hpp"
#include "frame_target.hpp"
#include "mesh_surface.hpp"
#include "offscreen.hpp"
#include "picture/color.hpp"
#include "shapes.hpp"
#include "sky_light.hpp"
#include "surface_pass.hpp"

namespace orbweaver::test {

/// The top of a cube 40 m wide, 10 x 10 m of it seen from above, lit evenly: at y = 20 m. The light of its
/// pixels, as a share of what it is without shade.
class Ground {
public:
    using Draw = std::function<void(const view::Gl&, GLuint depths, const view::Camera&, int size)>;
    Ground()
        : canvas_(kSize, kSize),
          ground_(canvas_.gl, kSize, kSize, view::FrameTarget::Depth::kept),
          picture_(canvas_.gl, kSize, kSize, view::FrameTarget::Depth::kept) {}

    void draw(const Draw& shade) {
        mesh::Validation validation;
        const auto data = mesh::build_surface_mesh(mesh::cube(40, 1), {}, "the test's cube", validation);
        const surface::MeshSurface cube(data.view(), std::nullopt, {});
        view::CubeSky sky;
        sky.size = 2;
        for (auto& face : sky.faces) face.assign(12, 0.5F);
        const view::Camera camera{{0, 32, 0.001}, {0, 20, 0}, 45.23972915};
        ground_.bind();
        ground_.clear_depths();
        view::SurfacePass(canvas_.gl, cube, {{1, 1, 1}, 0}, view::sky_light(sky)).draw(camera, kSize, kSize);
        ground_.copy_to(picture_.framebuffer(), kSize, kSize);
        ground_.copy_depths_to(picture_);
        picture_.bind();
        shade(canvas_.gl, ground_.depths(), camera, kSize);
        picture_.read(rgb_);
    }
    double left(double x, double z) const {
        const auto column = static_cast<std::size_t>((x / 10 + 0.5) * kSize);
        const auto row = static_cast<std::size_t>((z / 10 + 0.5) * kSize);
        return picture::linear_from_byte()[rgb_[3 * (row * kSize + column)]] / 0.5;
    }

private:
    static constexpr int kSize = 64;
    Offscreen canvas_;
    view::FrameTarget ground_, picture_;
    std::vector<std::uint8_t> rgb_;
};

}  // namespace orbweaver::test
