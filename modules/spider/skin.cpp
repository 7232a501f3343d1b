#include "skin.hpp"

#include <algorithm>

namespace orbweaver::spider {
namespace {

constexpr double kMostHairs = 3600;
constexpr double kHairs = 3;          // on a square whose side is a hair's length
constexpr double kHairWidth = 0.055;  // of its length

double area_of(const SkinBuilder& skin, std::size_t triangles) {
    const auto at = [&](std::uint32_t corner) {
        const auto& p = skin.vertices[corner].position;
        return Vec3{p[0], p[1], p[2]};
    };
    double area = 0;
    for (std::size_t i = 0; i < triangles; ++i) {
        const auto& t = skin.triangles[i];
        area += norm(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]))) / 2;
    }
    return area;
}

}  // namespace

Skin::Skin(const Species& species, const RandomStream& random)
    : species_(species), rest_(bone_count(species)), places_(rest_.size()) {
    const auto legs = rest_poses(species);
    SkeletonPose pose;
    pose.legs = legs;
    place_bones(species, pose, rest_);
    add_trunk(species, rest_, builder_);
    add_legs(species, rest_, builder_);
    add_palps(species, rest_, builder_);
    const std::size_t furred = builder_.triangles.size();
    add_chelicerae(species, rest_, builder_);
    add_eyes(species, builder_);
    builder_.smooth();
    if (species.coat.hair > 0) add_fur(furred, random);
    add_rods();
}

void Skin::add_fur(std::size_t triangles, const RandomStream& random) {
    std::vector<Vec3> leans;
    for (const BonePlace& bone : rest_) leans.push_back(bone.axes.x);
    leans[kThorax] = leans[kHead] = {-1, 0, 0};
    const double length = species_.coat.hair;
    const double count = std::min(kMostHairs, kHairs * area_of(builder_, triangles) / (length * length));
    builder_.add_fur({0, triangles, static_cast<std::size_t>(count), length, kHairWidth * length}, leans,
                     random);
}

void Skin::add_rods() {
    const Body& body = species_.body;
    rods_.resize(rest_.size());
    const auto add = [&](std::size_t bone, double begin, double end, double radius) {
        const BonePlace& place = rest_[bone];
        rods_[bone] = {place.at + begin * place.axes.x, place.at + end * place.axes.x, radius};
    };
    add(kThorax, -0.25 * body.thorax.x, 0.3 * body.thorax.x, (body.thorax.y + body.thorax.z) / 4);
    add(kHead, 0, 0.5 * body.head.x, (body.head.y + body.head.z) / 4);
    add(kAbdomen, 0.3 * body.abdomen.x, 0.75 * body.abdomen.x, (body.abdomen.y + body.abdomen.z) / 4);
    for (const std::size_t left : {0, 1}) {
        add(kRightChelicera + left, 0, 0.6 * body.chelicera.length, body.chelicera.thickness / 2);
        add(kRightPalp + left, 0, 0.7 * body.palp.length, body.palp.thickness / 2);
    }
    for (std::size_t leg = 0; leg < species_.limbs.size(); ++leg)
        for (std::size_t i = 0; i < kBones; ++i) {
            const Leg& limb = species_.limbs[leg].leg;
            if (limb.bone[i] > 0)
                add(kBodyBones + kBones * leg + i, 0, limb.bone[i] * limb.length, girth(species_, i, 0.5));
        }
}

void Skin::move(const SkeletonPose& pose, std::span<SkinMove> moves) noexcept {
    place_bones(species_, pose, places_);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
        const Frame& from = rest_[i].axes;
        const Frame& to = places_[i].axes;
        const auto turned = [&](double x, double y, double z) { return x * to.x + y * to.y + z * to.z; };
        SkinMove& move = moves[i];
        move.x = turned(from.x.x, from.y.x, from.z.x);
        move.y = turned(from.x.y, from.y.y, from.z.y);
        move.z = turned(from.x.z, from.y.z, from.z.z);
        const Vec3& rest = rest_[i].at;
        move.at = places_[i].at - (rest.x * move.x + rest.y * move.y + rest.z * move.z);
    }
}

void to_world(const BodyPose& pose, std::span<SkinMove> moves) noexcept {
    const auto turned = [&](const Vec3& v) { return v.x * pose.forward + v.y * pose.up + v.z * pose.right; };
    for (SkinMove& move : moves)
        move = {turned(move.x), turned(move.y), turned(move.z), to_world(pose, move.at)};
}

std::size_t Skin::memory_bytes() const noexcept {
    return (rest_.capacity() + places_.capacity()) * sizeof(BonePlace) +
           builder_.vertices.capacity() * sizeof(SkinVertex) +
           builder_.triangles.capacity() * sizeof(builder_.triangles[0]) + rods_.capacity() * sizeof(SkinRod);
}

}  // namespace orbweaver::spider
