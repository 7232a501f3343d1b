#include "skin_moves.hpp"

namespace orbweaver::view {

const char* const kMovedSource = R"(
uniform samplerBuffer moves;
uniform int bones;
vec3 moved(int creature, int bone, vec4 rest) {
    int row = 3 * (creature * bones + bone);
    return vec3(dot(texelFetch(moves, row), rest), dot(texelFetch(moves, row + 1), rest),
                dot(texelFetch(moves, row + 2), rest));
}
)";

SkinMoves::SkinMoves(const Gl& gl, Skins& skins) : skins_(skins), buffer_(gl) {}

void SkinMoves::update() {
    const auto moves = skins_.moves();
    const std::size_t bones = skins_.mesh().rods.size();
    creatures_ = bones > 0 ? static_cast<GLsizei>(moves.size() / bones) : 0;
    if (creatures_ == 0) return;
    origin_ = moves.front().at;
    rows_.clear();
    for (const SkinMove& move : moves) {
        const Vec3 at = move.at - origin_;
        for (const double number : {move.x.x, move.y.x, move.z.x, at.x, move.x.y, move.y.y, move.z.y, at.y,
                                    move.x.z, move.y.z, move.z.z, at.z})
            rows_.push_back(static_cast<float>(number));
    }
    buffer_.upload(rows_, GL_STREAM_DRAW, 0);
}

}  // namespace orbweaver::view
