#pragma once

#include <span>
#include <vector>

#include "skeleton.hpp"
#include "skin_builder.hpp"

namespace orbweaver::spider {

/// Parts of a creature's skin at rest, by procedure from its species; `rest` is where its bones are then.
void add_trunk(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin);
void add_legs(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin);
void add_palps(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin);
void add_chelicerae(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin);
void add_eyes(const Species& species, SkinBuilder& skin);

/// m, of a bone of a leg, `along` it from 0 to 1: its radius.
double girth(const Species& species, std::size_t bone, double along) noexcept;

/// From the body's frame.
void to_world(const BodyPose& pose, std::span<SkinMove> moves) noexcept;

/// The skin of a species, and where its bones go.
class Skin {
public:
    /// `species` lives as long as this.
    Skin(const Species& species, const RandomStream& random);

    SkinMesh mesh() const noexcept { return {builder_.vertices, builder_.triangles, rods_}; }
    /// Where a pose takes each bone from where it is at rest, body frame.
    void move(const SkeletonPose& pose, std::span<SkinMove> moves) noexcept;
    std::size_t memory_bytes() const noexcept;

private:
    void add_fur(std::size_t triangles, const RandomStream& random);
    void add_rods();

    const Species& species_;
    std::vector<BonePlace> rest_, places_;
    SkinBuilder builder_;
    std::vector<SkinRod> rods_;
};

}  // namespace orbweaver::spider
