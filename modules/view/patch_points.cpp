#include "patch_points.hpp"

#include <algorithm>
#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::view {

PatchPoints::PatchPoints(const Gl& gl, Patches& patches) : gl_(gl), patches_(patches), buffer_(gl) {}

void PatchPoints::update() {
    layout_ = patches_.layout();
    latest_ = patches_.points();
    const std::size_t body = layout_.rings * layout_.sides;
    const bool any = layout_.rings >= 4 && layout_.sides >= 3;
    layout_.bodies = any ? std::min(layout_.bodies, latest_.size() / body) : 0;
    if (layout_.bodies == 0) return;
    latest_ = latest_.first(layout_.bodies * body);
    GLint most = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (latest_.size() > static_cast<std::size_t>(most))
        throw Fault(FaultKind::limit, "Bodies of " + std::to_string(latest_.size()) +
                                          " control points are more than this graphics driver draws (" +
                                          std::to_string(most) + "); ask for fewer of them.");
    origin_ = latest_.front();
    texels_.clear();
    for (const Vec3& point : latest_) {
        const Vec3 at = point - origin_;
        for (const double number : {at.x, at.y, at.z, 0.0}) texels_.push_back(static_cast<float>(number));
    }
    buffer_.upload(texels_, GL_STREAM_DRAW, 0);
}

}  // namespace orbweaver::view
