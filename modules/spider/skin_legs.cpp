#include <algorithm>
#include <cmath>

#include "skin.hpp"

namespace orbweaver::spider {
namespace {

struct Girth {
    double begin, middle, end;  ///< thicknesses, of the femur's
};
constexpr std::array<Girth, kBones> kGirths{{{0.9, 1.0, 0.86},
                                             {0.82, 1.0, 0.8},
                                             {0.76, 0.86, 0.76},
                                             {0.72, 0.78, 0.58},
                                             {0.54, 0.5, 0.4},
                                             {0.4, 0.38, 0.24}}};
constexpr std::array kStations{0.1, 0.24, 0.5, 0.76, 0.9};  // of a bone, between its joints
constexpr std::size_t kSides = 12;

/// A chain of bones to be swept: where they begin, and the end.
struct BoneLine {
    std::vector<Vec3> joints;        ///< m; one more than bones
    std::vector<std::size_t> bones;  ///< that the skin goes with
    Vec3 across;                     ///< unit, at right angles to all of them
};

/// How much a place on a bone goes with the bone beyond the joint that is `away` of its length off.
double share_beyond(double away) noexcept { return 0.5 * std::clamp(1 - away / 0.22, 0.0, 1.0); }

/// Where on its chain a ring is.
struct Station {
    std::size_t bone = 0;
    double along = 0;  ///< of the bone, 0 to 1
};

struct Swept {
    SkinTube tube;
    std::vector<Station> stations;  ///< of each ring
};

/// `radius(bone, along)`, m.
template <class Radius>
Swept sweep(const BoneLine& chain, const Radius& radius) {
    const std::size_t count = chain.joints.size() - 1;
    Swept swept{{chain.joints.front(), {}, chain.joints.back()}, {}};
    const auto direction = [&](std::size_t i) {
        const Vec3 d = chain.joints[i + 1] - chain.joints[i];
        return d / norm(d);
    };
    const auto ring = [&](Station at, const Vec3& middle, const Vec3& x, double r, double stretch,
                          SkinBinding binding) {
        swept.tube.rings.push_back(
            {middle, {x, cross(chain.across, x), chain.across}, r * stretch, r * stretch, r, binding});
        swept.stations.push_back(at);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 x = direction(i), start = chain.joints[i];
        const double length = distance(chain.joints[i + 1], start);
        if (i > 0) {  // in the middle between both bones, as wide across as they are
            const Vec3 before = direction(i - 1), between = (x + before) / norm(x + before);
            const double r = 0.93 * (radius(i - 1, 1) + radius(i, 0)) / 2;
            ring({i, 0}, start, between, r, std::min(1.3, 1 / dot(x, between)),
                 {chain.bones[i - 1], chain.bones[i], 0.5});
        }
        for (const double along : kStations) {
            SkinBinding binding{chain.bones[i], chain.bones[i], 0};
            if (i > 0 && along < 0.5) binding = {chain.bones[i], chain.bones[i - 1], share_beyond(along)};
            if (i + 1 < count && along > 0.5)
                binding = {chain.bones[i], chain.bones[i + 1], share_beyond(1 - along)};
            const bool in_tip = i + 1 == count && (1 - along) * length < radius(i, 1);
            if (!in_tip) ring({i, along}, start + along * length * x, x, radius(i, along), 1, binding);
        }
    }
    const Vec3 x = direction(count - 1);
    const double r = radius(count - 1, 1);
    for (const double back : {0.8, 0.4, 0.12})  // of its radius, from the rounded end
        ring({count - 1, 1}, chain.joints.back() - back * r * x, x, std::sqrt(1 - (1 - back) * (1 - back)) * r,
             1, {chain.bones.back(), chain.bones.back(), 0});
    return swept;
}

/// Bands at the far ends of the long bones; feet are darker.
SkinPaint leg_paint(const Coat& coat, std::size_t bone, double along, double y) {
    const bool long_bone = bone == 1 || bone == 3 || bone == 4;
    double dark = bone == 5 ? 0.6 : 0.06;
    if (long_bone && along > 0.7) dark = 0.85;
    if (long_bone && along < 0.2) dark = 0.4;
    dark += y < 0 ? 0.12 : 0;
    return {coat.legs + std::min(1.0, dark) * (coat.marks - coat.legs), coat.gloss};
}

}  // namespace

double girth(const Species& species, std::size_t bone, double along) noexcept {
    const Girth& g = kGirths[bone];
    const double t = 2 * along - 1, share = 1 - t * t;
    const double ends = along < 0.5 ? g.begin : g.end;
    return species.coat.leg / 2 * (ends + share * (g.middle - ends));
}

void add_legs(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin) {
    for (std::size_t leg = 0; leg < species.limbs.size(); ++leg) {
        const Leg& limb = species.limbs[leg].leg;
        const auto places = rest.subspan(kBodyBones + kBones * leg, kBones);
        BoneLine chain;
        std::vector<std::size_t> kinds;
        chain.across = places[0].axes.z;
        chain.joints.push_back(places[0].at);
        for (std::size_t i = 0; i < kBones; ++i) {
            if (limb.bone[i] == 0) continue;
            chain.joints.push_back(places[i].at + limb.bone[i] * limb.length * places[i].axes.x);
            chain.bones.push_back(kBodyBones + kBones * leg + i);
            kinds.push_back(i);
        }
        const Swept swept =
            sweep(chain, [&](std::size_t i, double along) { return girth(species, kinds[i], along); });
        skin.add_tube(swept.tube, kSides, [&](std::size_t ring, double y, double) {
            const Station& at = swept.stations[ring];
            return leg_paint(species.coat, kinds[at.bone], at.along, y);
        });
    }
}

void add_palps(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin) {
    const Rod& size = species.body.palp;
    if (size.length == 0) return;
    // Up from the head and down to the tip, in the palp's plane; lengths as shares of the whole.
    constexpr std::array<Vec3, 5> kPieces{
        {{0.12, -0.01, 0}, {0.27, 0.18, 0}, {0.14, -0.02, 0}, {0.14, -0.14, 0}, {0.06, -0.19, 0}}};
    for (const std::size_t bone : {kRightPalp, kLeftPalp}) {
        const BonePlace& place = rest[bone];
        BoneLine chain{{place.at}, std::vector<std::size_t>(kPieces.size(), bone), place.axes.z};
        for (const Vec3& piece : kPieces)
            chain.joints.push_back(chain.joints.back() +
                                   size.length * (piece.x * place.axes.x + piece.y * place.axes.y));
        const Swept swept = sweep(chain, [&](std::size_t i, double along) {
            const double t = (static_cast<double>(i) + along) / kPieces.size();
            return size.thickness / 2 * (0.8 + 0.2 * t);
        });
        skin.add_tube(swept.tube, kSides, [&](std::size_t ring, double y, double) {
            return leg_paint(species.coat, swept.stations[ring].bone + 1 < kPieces.size() ? 2 : 5, 0.5, y);
        });
    }
}

}  // namespace orbweaver::spider
