#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame_target.hpp"
#include "manifest_text.hpp"
#include "orbweaver/contracts/input.hpp"
#include "orbweaver/contracts/picture_source.hpp"
#include "orbweaver/entry.hpp"
#include "patch_pass.hpp"
#include "patch_shade.hpp"
#include "sketch_pass.hpp"
#include "skin_pass.hpp"
#include "skin_shade.hpp"
#include "sky_pass.hpp"
#include "sky_source.hpp"
#include "surface_pass.hpp"
#include "thread_pass.hpp"

namespace orbweaver::view {
namespace {

struct Size {
    int width = 0;
    int height = 0;
};

Size asked_size(const Host& host) {
    const auto& size = host.options().numbers("size");
    const Request& request = host.request();
    return {request.width > 0 ? request.width : static_cast<int>(size[0]),
            request.height > 0 ? request.height : static_cast<int>(size[1])};
}

SurfaceLook asked_surface_look(const Options& options) {
    return {options.vector("surface.color"), options.number("surface.edges")};
}

ThreadLook asked_look(const Options& options) {
    return {options.number("thread.width"), options.vector("thread.color"), options.number("thread.alpha")};
}

/// Bodies of one kind.
struct SkinView {
    SkinMoves moves;
    SkinShade shade;
    SkinPass pass;
    SkinView(const Gl& gl, Skins& skins, const SkyLight& light, const KeyLight& key)
        : moves(gl, skins), shade(gl, skins.mesh(), key), pass(gl, skins.mesh(), light, key) {}
};

/// Bodies of patches of one kind.
struct PatchView {
    PatchPoints points;
    PatchShade shade;
    PatchPass pass;
    PatchView(const Gl& gl, Patches& patches, const SkyLight& light, const KeyLight& key)
        : points(gl, patches), shade(gl, key), pass(gl, patches, light, key) {}
};

/// Draws one picture each time the host presents.
class View final : public Module, public PictureSource {
public:
    void attach(Host& host) override;
    void run(Phase phase, const Frame& frame) override;
    void report(ModuleReport& report) override;

    int width() const noexcept override { return picture_->width(); }
    int height() const noexcept override { return picture_->height(); }
    std::span<const std::uint8_t> rgb() noexcept override;

private:
    void open_canvas(const Host& host);
    void make_passes(Host& host);
    void make_lit_passes(Host& host, const CubeSky& sky);
    void make_targets(Size size);
    Camera home_camera(Host& host) const;
    void obey_input();
    void follow_window();
    void draw_backdrop();
    void draw_bodies();
    bool any_body() const noexcept { return !skins_.empty() || !patches_.empty(); }
    bool deep() const noexcept { return surface_ || any_body(); }
    int fineness(Size size) const;

    Canvas* canvas_ = nullptr;
    Input* input_ = nullptr;
    bool fixed_size_ = true;  // a film's pictures keep their size whatever becomes of the window
    Gl gl_;
    std::optional<SkyPass> sky_;
    std::optional<SurfacePass> surface_;
    std::vector<std::unique_ptr<ThreadPass>> threads_;
    std::vector<std::unique_ptr<SketchPass>> sketches_;
    std::vector<std::unique_ptr<SkinView>> skins_;
    std::vector<std::unique_ptr<PatchView>> patches_;
    std::optional<FrameTarget> backdrop_;  // sky and surface: they change only with the camera
    std::optional<FrameTarget> bodies_;    // the same with the bodies, where there are any
    std::optional<FrameTarget> picture_;
    bool backdrop_stale_ = true;
    Camera home_;
    Camera camera_;
    std::vector<std::uint8_t> rgb_;
    bool rgb_stale_ = true;
    std::int64_t pictures_ = 0;
};

void View::attach(Host& host) {
    input_ = host.find<Input>();
    const Request& request = host.request();
    fixed_size_ = !request.window || !request.frames_directory.empty() || !request.video_file.empty();
    open_canvas(host);
    gl_ = load_gl(*canvas_);
    make_passes(host);
    make_targets(asked_size(host));
    home_ = camera_ = home_camera(host);
    host.provide<PictureSource>(*this);
}

void View::open_canvas(const Host& host) {
    canvas_ = host.find<Canvas>();
    const auto [width, height] = asked_size(host);
    std::string why;
    if (!canvas_->open(width, height, host.scene().name.c_str(), why)) throw Fault(FaultKind::internal, why);
}

void View::make_passes(Host& host) {
    const CubeSky sky = load_sky(host);
    sky_.emplace(gl_, sky);
    make_lit_passes(host, sky);
    for (const Threads* threads : host.collect<Threads>())
        threads_.push_back(std::make_unique<ThreadPass>(gl_, *threads, asked_look(host.options())));
    for (Sketch* sketch : host.collect<Sketch>())
        if (sketch->wanted()) sketches_.push_back(std::make_unique<SketchPass>(gl_, *sketch));
}

/// What the sky lights.
void View::make_lit_passes(Host& host, const CubeSky& sky) {
    const Surface* surface = host.find<Surface>();
    const auto skins = host.collect<Skins>();
    const auto patches = host.collect<Patches>();
    const bool bodies = !skins.empty() || !patches.empty();
    if (surface == nullptr && !bodies) return;
    const SkyLight light = sky_light(sky);
    if (surface != nullptr) surface_.emplace(gl_, *surface, asked_surface_look(host.options()), light);
    const KeyLight key = bodies ? key_light(sky) : KeyLight{};
    for (Skins* each : skins) skins_.push_back(std::make_unique<SkinView>(gl_, *each, light, key));
    for (Patches* each : patches) patches_.push_back(std::make_unique<PatchView>(gl_, *each, light, key));
}

/// Pixels of the backdrop a pixel of the picture, along a side: the steps of surfaces' and skins' rims are
/// smoothed.
int View::fineness(Size size) const {
    GLint largest = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    return deep() && 2 * std::max(size.width, size.height) <= largest ? 2 : 1;
}

void View::make_targets(Size size) {
    const auto depth = deep() ? FrameTarget::Depth::kept : FrameTarget::Depth::none;
    const Size fine{fineness(size) * size.width, fineness(size) * size.height};
    picture_.emplace(gl_, size.width, size.height, depth);
    backdrop_.emplace(gl_, fine.width, fine.height, depth);
    if (any_body()) bodies_.emplace(gl_, fine.width, fine.height, depth);
    backdrop_stale_ = true;
}

Camera View::home_camera(Host& host) const {
    const Options& options = host.options();
    std::vector<Vec3> points;
    for (const Threads* threads : host.collect<Threads>())
        points.insert(points.end(), threads->points().begin(), threads->points().end());
    if (const Surface* surface = host.find<Surface>())
        points.insert(points.end(), surface->vertices().begin(), surface->vertices().end());
    for (Patches* patches : host.collect<Patches>()) {
        const auto now = patches->points();
        points.insert(points.end(), now.begin(), now.end());
    }
    const Vec3 target = options.has("camera.target") ? options.vector("camera.target") : middle(points);
    const double aspect = static_cast<double>(width()) / height();
    Camera camera = frame_points(points, target, options.number("camera.fov"), aspect);
    if (options.has("camera.position")) camera.position = options.vector("camera.position");
    constexpr double kTooNear = 1e-9;  // of the distance from the origin: no direction is left beside rounding
    if (distance(camera.position, camera.target) <= kTooNear * (1 + norm(camera.target)))
        host.report_fault({options.where("camera.position"), "camera.position is where camera.target is",
                           "two different points", "move the camera away from what it looks at"});
    return camera;
}

void View::obey_input() {
    if (input_ == nullptr) return;
    const InputEvents& events = input_->latest();
    if (!events.reset_camera && events.orbit_x == 0 && events.orbit_y == 0 && events.zoom == 0) return;
    if (events.reset_camera) camera_ = home_;
    camera_ = zoom(orbit(camera_, events.orbit_x, events.orbit_y), events.zoom);
    backdrop_stale_ = true;
}

void View::follow_window() {
    const Size size{canvas_->width(), canvas_->height()};
    const bool same = size.width == width() && size.height == height();
    if (!fixed_size_ && !same && size.width > 0 && size.height > 0) make_targets(size);
}

void View::draw_backdrop() {
    if (backdrop_stale_) {
        backdrop_->bind();
        sky_->draw(camera_, static_cast<double>(width()) / height());
        if (deep()) backdrop_->clear_depths();
        if (surface_) surface_->draw(camera_, backdrop_->width(), backdrop_->height());
        backdrop_stale_ = false;
    }
    if (any_body()) draw_bodies();
    const FrameTarget& drawn = any_body() ? *bodies_ : *backdrop_;
    drawn.copy_to(picture_->framebuffer(), width(), height());
    if (deep()) drawn.copy_depths_to(*picture_);
}

/// All shades first: bodies have none on them.
void View::draw_bodies() {
    backdrop_->copy_to(bodies_->framebuffer(), bodies_->width(), bodies_->height());
    backdrop_->copy_depths_to(*bodies_);
    bodies_->bind();
    for (const auto& each : skins_) {
        each->moves.update();
        each->shade.draw(each->moves, backdrop_->depths(), camera_, bodies_->width(), bodies_->height());
    }
    for (const auto& each : patches_) {
        each->points.update();
        each->shade.draw(each->points, backdrop_->depths(), camera_, bodies_->width(), bodies_->height());
    }
    for (const auto& each : skins_) each->pass.draw(each->moves, camera_, bodies_->width(), bodies_->height());
    for (const auto& each : patches_)
        each->pass.draw(each->points, camera_, bodies_->width(), bodies_->height());
}

void View::run(Phase, const Frame&) {
    obey_input();
    follow_window();
    draw_backdrop();
    picture_->bind();
    for (const auto& each : threads_) each->draw(camera_, width(), height());
    for (const auto& each : sketches_) each->draw(camera_, width(), height());
    picture_->copy_to(0, canvas_->width(), canvas_->height());
    canvas_->present();
    rgb_stale_ = true;
    ++pictures_;
}

std::span<const std::uint8_t> View::rgb() noexcept {
    if (rgb_stale_) picture_->read(rgb_);
    rgb_stale_ = false;
    return rgb_;
}

void View::report(ModuleReport& report) {
    std::size_t bytes =
        sky_->memory_bytes() + backdrop_->memory_bytes() + picture_->memory_bytes() + rgb_.capacity();
    if (surface_) bytes += surface_->memory_bytes();
    if (bodies_) bytes += bodies_->memory_bytes();
    for (const auto& each : skins_)
        bytes += each->moves.memory_bytes() + each->shade.memory_bytes() + each->pass.memory_bytes();
    for (const auto& each : patches_)
        bytes += each->points.memory_bytes() + each->shade.memory_bytes() + each->pass.memory_bytes();
    for (const auto& each : threads_) bytes += each->memory_bytes();
    for (const auto& each : sketches_) bytes += each->memory_bytes();
    report.memory_bytes = bytes;
    report.measure("pictures", pictures_);
    report.measure("width", static_cast<std::int64_t>(width()));
    report.measure("height", static_cast<std::int64_t>(height()));
    report.measure("renderer", std::string(reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER))));
}

}  // namespace
}  // namespace orbweaver::view

ORBWEAVER_MODULE(orbweaver::view::View)
