#include "scribe.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "draft.hpp"
#include "orbweaver/fault.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// What the probing mode was given last.
struct Given {
    std::vector<Vec3> points;
    std::uint32_t side = 0;
    Bitmap coverage, dilated;
    double mesh = 0, blur = 0;
    ModeSettings settings;
    std::uint64_t bits = 0;
};
Given given;

/// Takes three spiral threads, adds two and thickens part of one.
WebChange probe(const Writing& writing) {
    given = {{writing.web.points.begin(), writing.web.points.end()},
             writing.page.side,
             writing.coverage,
             writing.dilated,
             writing.mesh,
             writing.blur,
             writing.settings,
             writing.random.bits(7)};
    const auto first = static_cast<std::uint32_t>(writing.web.segments.size() / 2);
    const ThreadSegment &one = writing.web.segments[first], &other = writing.web.segments[first + 1];
    return {{first, first + 1, first + 5},
            {{one.a, one.b, first, 2}, {other.a, other.b, first, 3}},
            {{first + 9, 0.25, 0.5, 4}}};
}
constexpr Mode kProbe{"probe", "", probe};

const Bitmap kWord = test::drawn({
    "##..##",  //
    "##..##",  //
    "######",  //
    "##..##",  //
    "##..##",  //
});

/// Of 32 radii and 16 turns.
struct Scene {
    test::HandMade web = test::turned(test::make_orb(32, 16));
    test::HandMadeDraft draft{web};
    Scribe scribe{&kProbe, test::target_of(kWord), {}, {}, RandomStream(3, "attachments"), {}};

    Scene() {
        scribe.where.side = 200;
        scribe.where.blur = 1.5;
    }
    Lettering page(bool best_place, double most_ink, std::uint32_t side = 200) const {
        WhereToWrite where = scribe.where;
        where.best_place = best_place;
        where.most_ink = most_ink;
        where.side = side;
        return lay_on(web, scribe.target, where);
    }
};

void check_same(const Legibility& found, const Legibility& expected) {
    CHECK(found.iou == expected.iou);
    CHECK(found.ssim == expected.ssim);
    CHECK(found.contrast == expected.contrast);
}

Legibility read_in(const test::HandMade& web, const Lettering& lettering) {
    return measure_legibility(web.points, web.segments, lettering);
}

}  // namespace

TEST_CASE("a mode is given the target as it lies on the plain web, and all that the scene chose", "[unit]") {
    Scene scene;
    scene.scribe.settings = {4, 2.5, 0.5, 3, 0.125};
    scene.scribe.write(scene.draft);
    const Lettering page = scene.page(false, 0);
    CHECK(given.points == scene.web.points);
    CHECK(given.side == 200);
    CHECK(given.coverage == page.coverage);
    CHECK(given.dilated == dilate(page.coverage, kDilation));
    CHECK(given.mesh == scene.web.mesh);
    CHECK(given.blur == 1.5 * scene.web.mesh);
    CHECK(given.settings.score_threshold == 4);
    CHECK(given.settings.width == 2.5);
    CHECK(given.settings.attachments == 0.5);
    CHECK(given.settings.outline == 3);
    CHECK(given.settings.loss == 0.125);
    CHECK(given.bits == RandomStream(3, "attachments").bits(7));
}

TEST_CASE("the draft is changed once, as the mode says, and told what that came to", "[unit]") {
    Scene scene;
    const Inscription written = scene.scribe.write(scene.draft);
    REQUIRE(scene.draft.asked.size() == 1);
    const WebChange& change = scene.draft.asked[0];
    CHECK((written.removed == 3 && written.added == 2 && written.thickened == 1));
    CHECK(change.removed.size() == 3);
    CHECK(change.added.size() == 2);
    REQUIRE(change.thickened.size() == 1);
    CHECK(change.thickened[0].width == 4);
    const Naturalness cost = compare(scene.web, change, scene.draft.after);
    CHECK(written.naturalness.silk_share == cost.silk_share);
    CHECK(written.naturalness.mean_shift == cost.mean_shift);
    CHECK(written.naturalness.max_tension_ratio == 1.75);
    CHECK(written.naturalness.new_slack == cost.new_slack);
    CHECK(cost.mean_shift > 0);
}

TEST_CASE("it is read where it was written, before and after the web came to rest", "[unit]") {
    Scene scene;
    const Inscription written = scene.scribe.write(scene.draft);
    const Lettering page = scene.page(false, 0);
    CHECK(written.lettering.coverage == page.coverage);
    CHECK(written.lettering.blur == page.blur);
    check_same(written.plain, read_in(scene.web, page));
    check_same(written.at_rest, read_in(scene.draft.after, page));
    CHECK(written.plain.contrast != written.at_rest.contrast);
}

TEST_CASE("a page to be judged on is not the one to be written on, and shows the same place", "[unit]") {
    Scene scene;
    const Mode* legible = find_mode("legible");
    scene.scribe.mode = GENERATE_COPY(&kProbe, legible);
    scene.scribe.write(scene.draft);
    scene.scribe.judged_on = 340;
    const Inscription written = scene.scribe.write(scene.draft);
    REQUIRE(scene.draft.asked.size() == 2);
    REQUIRE(scene.draft.asked[0].thickened.size() == scene.draft.asked[1].thickened.size());
    for (std::size_t i = 0; i < scene.draft.asked[0].thickened.size(); ++i)
        CHECK(scene.draft.asked[0].thickened[i].width == scene.draft.asked[1].thickened[i].width);
    CHECK(given.side == 200);
    const Lettering page =
        scene.page(scene.scribe.mode == legible, scene.scribe.settings.loss / 2, 340);  // 3 - 1 times the silk
    CHECK(written.lettering.page.side == 340);
    CHECK(written.lettering.coverage == page.coverage);
    check_same(written.plain, read_in(scene.web, page));
    check_same(written.at_rest, read_in(scene.draft.after, page));
}

TEST_CASE("legible writing alone seeks the best place, no larger than its silk is enough for", "[unit]") {
    Scene scene;
    scene.scribe.mode = find_mode("legible");
    for (const auto& [width, loss, most_ink, less] :
         {std::tuple{3.0, 0.2, 0.1, 0.08}, {5.0, 0.2, 0.05, 0.04}, {1.0, 0.001, 1.0, 0.001}}) {
        scene.scribe.settings.width = width;
        scene.scribe.settings.loss = loss;
        const Lettering page = scene.page(true, most_ink);
        CHECK(scene.scribe.write(scene.draft).lettering.coverage == page.coverage);
        CHECK_FALSE(page.coverage == scene.page(true, less).coverage);
    }
    scene.scribe.mode = find_mode("removal");
    scene.scribe.where.best_place = true;  // the mode says otherwise
    CHECK(scene.scribe.write(scene.draft).lettering.coverage == scene.page(false, 0).coverage);
}

TEST_CASE("a web in which nothing can be written is left as it is", "[unit]") {
    Scene scene;
    scene.scribe.where.position = {9, 9};
    CHECK_THROWS_AS(scene.scribe.write(scene.draft), Fault);
    CHECK(scene.draft.asked.empty());
}
