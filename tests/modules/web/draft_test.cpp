#include "draft.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

Web thesis_web() {
    Web web{web::test::thesis_layout(), {}};
    web.network = find_form(web.layout, web::test::default_silks(), web::test::kMass, 0, web::test::kGravity);
    return web;
}

const Settling kHow{web::test::kGravity, mass_spring::LinearSolverKind::automatic, nullptr};

}  // namespace

TEST_CASE("a web from which spiral is taken comes to rest again, elsewhere", "[unit]") {
    Draft draft(thesis_web(), kHow);
    CHECK(draft.plain().residual <= 1e-12);
    WebChange change;
    for (std::uint32_t i = 0; i < draft.plain().segments.size(); ++i)
        if (draft.plain().segments[i].kind == static_cast<std::uint32_t>(Kind::spiral) && i % 3 == 0)
            change.removed.push_back(i);
    const WebAtRest& changed = draft.changed(change);
    CHECK(changed.residual <= 1e-12);
    CHECK(changed.segments.size() + change.removed.size() == draft.plain().segments.size());
    // What was taken pulled the radii towards it: they are elsewhere now.
    double farthest = 0;
    for (std::size_t i = 0; i < changed.points.size(); ++i)
        farthest = std::max(farthest, distance(changed.points[i], draft.plain().points[i]));
    CHECK(farthest > 1e-6);
}

TEST_CASE("every form is made of the plain web, whatever was tried before", "[unit]") {
    Draft draft(thesis_web(), kHow);
    const std::vector<Vec3> plain(draft.plain().points.begin(), draft.plain().points.end());
    draft.changed({{}, {}, {{500, 0.25, 0.75, 3}}});
    const WebAtRest& back = draft.changed({});
    REQUIRE(back.points.size() == plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) CHECK(distance(back.points[i], plain[i]) < 1e-9);
}

TEST_CASE("what draws together when it is written in is told", "[unit]") {
    Draft draft(thesis_web(), kHow);
    std::vector<std::uint32_t> all(draft.plain().segments.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    CHECK_THROWS_AS(draft.changed({all, {}, {}}), Fault);
}
