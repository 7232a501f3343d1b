#include "skin.hpp"

#include <map>
#include <numeric>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Vec3 at(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

Vec3 moved(const SkinMove& move, const Vec3& p) { return move.at + p.x * move.x + p.y * move.y + p.z * move.z; }

/// As skins.hpp defines it: the weighted mean of where both bones take a corner.
Vec3 deformed(const SkinVertex& vertex, std::span<const SkinMove> moves) {
    Vec3 sum;
    for (std::size_t i = 0; i < 2; ++i)
        sum += static_cast<double>(vertex.weights[i]) * moved(moves[vertex.bones[i]], at(vertex.position));
    return sum;
}

/// Parts that hang together, by their lowest corner: the volume of each, m^3, positive where it is wound
/// outward.
std::map<std::uint32_t, double> volumes(const SkinMesh& mesh) {
    std::vector<std::uint32_t> part(mesh.vertices.size());
    std::iota(part.begin(), part.end(), 0);
    const auto root = [&](std::uint32_t v) {
        while (part[v] != v) v = part[v] = part[part[v]];
        return v;
    };
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t) part[root(v)] = root(t[0]);
    std::map<std::uint32_t, double> sums;
    for (const auto& t : mesh.triangles) {
        const Vec3 origin = at(mesh.vertices[root(t[0])].position);
        sums[root(t[0])] +=
            dot(at(mesh.vertices[t[0]].position) - origin,
                cross(at(mesh.vertices[t[1]].position) - origin, at(mesh.vertices[t[2]].position) - origin)) /
            6;
    }
    return sums;
}

}  // namespace

TEST_CASE("skins are closed, wound outward, and their weights sum to 1", "[unit]") {
    for (const std::string& name : kCreatures) {
        INFO(name);
        const Species species = creature(name);
        const Skin skin(species, {0, name});
        const SkinMesh mesh = skin.mesh();
        REQUIRE(mesh.triangles.size() > 1000);
        CHECK(mesh.rods.size() == bone_count(species));
        std::map<Edge, int> sides;  // how often each edge is passed in its direction
        for (const auto& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
        for (const auto& [edge, count] : sides) {
            CHECK(count == 1);
            CHECK(sides.count({edge.second, edge.first}) == 1);
        }
        for (const auto& [part, volume] : volumes(mesh)) CHECK(volume > 0);
        for (const SkinVertex& vertex : mesh.vertices) {
            CHECK(vertex.weights[0] + vertex.weights[1] == 1);
            CHECK(vertex.weights[1] >= 0);
            CHECK(std::max(vertex.bones[0], vertex.bones[1]) < bone_count(species));
            CHECK(norm(at(vertex.normal)) == Approx(1).margin(1e-6));  // floats
        }
    }
}

TEST_CASE("normals of a ball point away from its middle", "[unit]") {
    SkinBuilder skin;
    const Vec3 middle{1, 2, 3};
    skin.add_ball(middle, 0.5, 0, {});
    skin.smooth();
    for (const SkinVertex& vertex : skin.vertices) {
        const Vec3 out = at(vertex.position) - middle;
        CHECK(norm(out) == Approx(0.5).margin(1e-6));
        CHECK(dot(out, at(vertex.normal)) > 0.5 * std::cos(5 * kDegree));  // corners 22 degrees apart
    }
}

TEST_CASE("at rest a skin is what it was made, and a pose that is at rest elsewhere moves it rigidly",
          "[unit]") {
    for (const std::string& name : kCreatures) {
        INFO(name);
        const Species species = creature(name);
        Skin skin(species, {0, name});
        const auto legs = rest_poses(species);
        SkeletonPose rest;
        rest.legs = legs;
        std::vector<SkinMove> moves(bone_count(species));
        skin.move(rest, moves);
        for (const SkinVertex& vertex : skin.mesh().vertices)
            CHECK(distance(deformed(vertex, moves), at(vertex.position)) < 1e-15);
        // Somewhere else, and turned by 3-4-5 about y.
        const BodyPose body{{3, -2, 5}, {0.6, 0, 0.8}, {0, 1, 0}, {-0.8, 0, 0.6}};
        to_world(body, moves);
        for (const SkinVertex& vertex : skin.mesh().vertices)
            CHECK(distance(deformed(vertex, moves), to_world(body, at(vertex.position))) < 1e-14);
    }
}

TEST_CASE("skin goes with its bones: feet to where the legs reach, the abdomen with its bend", "[unit]") {
    const Species species = creature("huntsman");
    Skin skin(species, {0, "huntsman"});
    const std::size_t count = species.limbs.size();
    const auto rest = rest_poses(species);
    std::vector<LegPose> legs;
    for (const Limb& limb : species.limbs) legs.push_back(LegalPoses(limb.leg).next());
    SkeletonPose pose;
    pose.legs = legs;
    pose.bend = 0.5;
    std::vector<SkinMove> moves(bone_count(species));
    skin.move(pose, moves);
    for (std::size_t leg = 0; leg < count; ++leg) {
        const Limb& limb = species.limbs[leg];
        const Vec3 foot = to_body(limb, foot_position(limb.leg, legs[leg]));
        double nearest = 1;
        for (const SkinVertex& vertex : skin.mesh().vertices)
            nearest = std::min(nearest, distance(deformed(vertex, moves), foot));
        CHECK(nearest < 1e-8);  // the tip is a corner, kept in floats
    }
    const auto end = std::ranges::min_element(skin.mesh().vertices, {}, [](const SkinVertex& v) {
        return v.bones[0] == kAbdomen && v.weights[0] == 1 ? v.position[0] : 1;
    });
    CHECK(deformed(*end, moves).y > at(end->position).y + 0.4 * species.body.abdomen.x * std::sin(0.5));
}

TEST_CASE("a coat's hair grows to its length, and a bald creature has none", "[unit]") {
    Species species = creature("tarantula");
    const Skin furred(species, {0, "fur"});
    species.coat.hair = 0;
    const Skin bald(species, {0, "fur"});
    const std::size_t hairs = (furred.mesh().triangles.size() - bald.mesh().triangles.size()) / 4;
    CHECK(hairs > 1000);
    CHECK(furred.memory_bytes() > bald.memory_bytes());
    const Skin again(creature("tarantula"), {0, "fur"});
    CHECK(again.mesh().vertices.back().position == furred.mesh().vertices.back().position);
}
