#include "shells.hpp"

#include <array>

namespace orbweaver::mesh {

namespace {

/// Walks each shell once, carrying along whether the winding has turned.
class ShellWalk {
public:
    ShellWalk(std::span<const Triangle> triangles, const Adjacency& adjacency)
        : turned_(triangles.size()),
          fan_crossed_(adjacency.fan.size()),
          found_{std::vector<std::uint32_t>(triangles.size(), kNone)} {
        mesh_.triangles = triangles;
        mesh_.across = adjacency.across;
        mesh_.fan_first = adjacency.fan_first;
        mesh_.fan = adjacency.fan;
    }

    Shells walk() {
        for (std::uint32_t t = 0; t < found_.shell.size(); ++t)
            if (found_.shell[t] == kNone) walk_shell(t);
        count_flipped();
        return std::move(found_);
    }

private:
    void walk_shell(std::uint32_t seed) {
        one_sided_ = false;
        enter(seed, 0);
        while (!waiting_.empty()) {
            const std::uint32_t triangle = waiting_.back();
            waiting_.pop_back();
            for (std::uint32_t edge = 0; edge < 3; ++edge) cross(triangle, edge);
        }
        if (one_sided_) ++found_.one_sided;
        ++found_.count;
    }

    void cross(std::uint32_t triangle, std::uint32_t edge) {
        const std::uint32_t code = mesh_.across[triangle][edge];
        if (is_neighbour(code)) {
            const auto turned = static_cast<std::uint8_t>(turned_[triangle] ^ (is_flipped(code) ? 1 : 0));
            const std::uint32_t next = across_triangle(code);
            if (found_.shell[next] == kNone)
                enter(next, turned);
            else if (turned_[next] != turned)
                one_sided_ = true;
        } else if (code == kNonManifold) {
            const auto faces = fan_at(mesh_, triangle, edge);
            std::uint8_t& crossed = fan_crossed_[static_cast<std::size_t>(faces.data() - mesh_.fan.data())];
            if (crossed != 0) return;
            crossed = 1;
            for (const std::uint32_t face : faces)
                if (found_.shell[face / 4] == kNone) enter(face / 4, turned_[triangle]);
        }
    }

    void enter(std::uint32_t triangle, std::uint8_t turned) {
        found_.shell[triangle] = found_.count;
        turned_[triangle] = turned;
        waiting_.push_back(triangle);
    }

    void count_flipped() {
        std::vector<std::array<std::uint64_t, 2>> wound(found_.count);
        for (std::size_t t = 0; t < turned_.size(); ++t) ++wound[found_.shell[t]][turned_[t]];
        for (std::uint32_t t = 0; t < turned_.size(); ++t) {
            const auto& [straight, turned] = wound[found_.shell[t]];
            if (turned_[t] != (turned > straight ? 0 : 1)) continue;
            if (found_.flipped++ == 0) found_.first_flipped = t;
        }
    }

    SurfaceMesh mesh_;
    std::vector<std::uint8_t> turned_;       ///< against its shell's first triangle
    std::vector<std::uint8_t> fan_crossed_;  ///< by its first face: once is enough
    std::vector<std::uint32_t> waiting_;
    bool one_sided_ = false;
    Shells found_;
};

}  // namespace

Shells find_shells(std::span<const Triangle> triangles, const Adjacency& adjacency) {
    return ShellWalk(triangles, adjacency).walk();
}

}  // namespace orbweaver::mesh
