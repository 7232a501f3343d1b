#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

std::vector<std::uint8_t> covered(const Layout& layout) {
    std::vector<std::uint8_t> found(layout.positions.size(), 0);
    for (const Piece& piece : layout.pieces)
        if (piece.kind == Kind::spiral) found[piece.a] = found[piece.b] = 1;
    return found;
}

/// The way from a mass to the nearest mass of any other spoke.
double nearest_elsewhere(const Layout& layout, const std::vector<Index>& own, Index from) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& spoke : layout.spokes) {
        if (spoke == own) continue;
        for (auto i = spoke.begin() + 1; i != spoke.end() - 1; ++i)
            least = std::min(least, distance(layout.positions[*i], layout.positions[from]));
    }
    return least;
}

Layout layout_with(const Construction& how) {
    return construct(web::test::site_of(web::test::thesis_anchors()), how, RandomStream(1, ""));
}

}  // namespace

TEST_CASE("the spiral touches neither frame nor hub and joins no pair twice", "[unit]") {
    const Layout layout = web::test::thesis_layout();
    std::set<Index> barred(layout.frame.begin(), layout.frame.end());
    barred.insert(layout.hub.begin(), layout.hub.end());
    std::set<std::pair<Index, Index>> joined;
    for (const Piece& piece : layout.pieces) {
        if (piece.kind != Kind::spiral) continue;
        CHECK(barred.count(piece.a) + barred.count(piece.b) == 0);
        CHECK(joined.insert(std::minmax(piece.a, piece.b)).second);
    }
    CHECK(joined.size() > 1000);
}

TEST_CASE("no spoke is left with more bare masses than the density allows", "[unit]") {
    for (const std::int64_t density : {0, 2, 5, 9}) {
        Construction how;
        how.spiral_density = density;
        how.spiral_end = 0;
        const double shortest = 0.1 * how.spokes.placement;  // where spokes all but touch, no thread is laid
        const Layout layout = layout_with(how);
        const auto found = covered(layout);
        for (const auto& spoke : layout.spokes)
            CHECK(std::count_if(spoke.begin() + 1, spoke.end() - 1, [&](Index i) {
                      return found[i] == 0 && nearest_elsewhere(layout, spoke, i) >= shortest;
                  }) <= density);
    }
}

TEST_CASE("the spiral keeps the distances asked for from frame and hub", "[unit]") {
    Construction how;
    how.spiral_start = 0.03;
    how.spiral_end = 0.05;
    const Layout layout = layout_with(how);
    const auto found = covered(layout);
    for (const auto& spoke : layout.spokes)
        for (const Index i : spoke) {
            if (found[i] == 0) continue;
            CHECK(distance(layout.positions[i], layout.positions[spoke.front()]) >= 0.03);
            CHECK(distance(layout.positions[i], layout.positions[spoke.back()]) >= 0.05);
        }
}

TEST_CASE("masses farther apart on the spokes make a sparser spiral", "[unit]") {
    std::size_t before = SIZE_MAX;
    for (const double placement : {7e-3, 9e-3, 11e-3, 15e-3}) {  // thesis, section 5.3.4
        Construction how;
        how.spokes.placement = placement;
        const Layout layout = layout_with(how);
        const auto pieces = static_cast<std::size_t>(std::count_if(
            layout.pieces.begin(), layout.pieces.end(), [](const Piece& p) { return p.kind == Kind::spiral; }));
        CHECK(pieces < before);
        before = pieces;
    }
}

TEST_CASE("frame masses farther apart make fewer spokes", "[unit]") {
    std::size_t before = SIZE_MAX;
    for (const double placement : {20e-3, 30e-3, 40e-3, 57e-3}) {  // thesis, section 5.3.5
        Construction how;
        how.inner_frame.placement = placement;
        const std::size_t spokes = layout_with(how).spokes.size();
        CHECK(spokes < before);
        before = spokes;
    }
}
