#include "writing_study.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "draft.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

constexpr std::uint32_t kFine = 1200;  ///< pixels of the raster on which all are judged

const Bitmap kBar = test::drawn({"########", "########"});

struct Studied {
    test::HandMade web = test::turned(test::make_orb(24, 12));
    test::HandMadeDraft draft{web};
    Scribe scribe{find_mode("outline"), test::target_of(kBar), {}, {}, RandomStream(3, "attachments"), {}};

    Studied() {
        scribe.where.side = 150;
        scribe.where.blur = 0.25;
        scribe.where.position = {0.02, 0.08};
        scribe.where.size = 0.08;
    }
    /// What a scribe of its own writes, judged on the fine raster.
    Inscription by_scribe(const char* mode, std::uint32_t side, double loss) const {
        Scribe own = scribe;
        own.mode = find_mode(mode);
        own.where.side = side;
        own.settings.loss = loss;
        own.judged_on = kFine;
        test::HandMadeDraft fresh{web};
        return own.write(fresh);
    }
};

void check_same(const WritingWays::Outcome& found, const Inscription& expected) {
    CHECK(found.iou == expected.at_rest.iou);
    CHECK(found.ssim == expected.at_rest.ssim);
    CHECK(found.contrast == expected.at_rest.contrast);
    CHECK(found.plain_iou == expected.plain.iou);
    CHECK(found.silk_share == expected.naturalness.silk_share);
    CHECK(found.max_tension_ratio == expected.naturalness.max_tension_ratio);
    CHECK(found.mean_shift == expected.naturalness.mean_shift);
    CHECK(found.spacing_distance == expected.naturalness.spacing_distance);
    CHECK(found.new_slack == expected.naturalness.new_slack);
    CHECK(found.blocks.size() == expected.lettering.blocks.size());
}

void check_near(const Vec3& found, const Vec3& expected, double within) {
    CAPTURE(found.x, found.y, found.z, expected.x, expected.y, expected.z);
    CHECK(distance(found, expected) < within);
}

}  // namespace

TEST_CASE("ways of writing are the modes, but for removal at random gaps", "[unit]") {
    const Studied studied;
    const WritingStudy study(studied.scribe, "");
    REQUIRE(study.ways().size() + 1 == modes().size());
    for (std::size_t i = 0; i < study.ways().size(); ++i) {
        CHECK(study.ways()[i].name == modes()[i].name);
        CHECK(study.ways()[i].meaning == modes()[i].meaning);
        CHECK(study.weighs_loss(i) == (modes()[i].name == "legible"));
    }
    CHECK(modes().back().name == "random_gaps");
}

TEST_CASE("a study knows its text from the start, and its web once there is one", "[unit]") {
    Studied studied;
    WritingStudy study(studied.scribe, "SOME\nPIG");
    CHECK(study.text() == "SOME\nPIG");
    CHECK_FALSE(study.has_web());
    study.write_in(studied.draft);
    CHECK(study.has_web());
    CHECK(study.blur() == 0.25 * studied.web.mesh);
}

TEST_CASE("each way writes as its mode does, and is judged on one fine raster", "[unit]") {
    Studied studied;
    WritingStudy study(studied.scribe, "");
    study.write_in(studied.draft);
    for (std::size_t way = 0; way < study.ways().size(); ++way) {
        INFO(study.ways()[way].name);
        check_same(study.write(way, {}), studied.by_scribe(study.ways()[way].name, 150, 0.3));
    }
}

TEST_CASE("what an effort does not say is as the scene has it, whatever an earlier one said", "[unit]") {
    Studied studied;
    WritingStudy study(studied.scribe, "");
    study.write_in(studied.draft);
    const auto coarse = study.write(1, {60, {}}), frugal = study.write(0, {{}, 0.02});
    check_same(coarse, studied.by_scribe("removal", 60, 0.3));
    check_same(frugal, studied.by_scribe("legible", 150, 0.02));
    const auto as_it_is = study.write(0, {});
    check_same(as_it_is, studied.by_scribe("legible", 150, 0.3));
    CHECK(coarse.silk_share != study.write(1, {}).silk_share);
    CHECK(frugal.silk_share < as_it_is.silk_share);
}

TEST_CASE("a block's middle and sides are where the words stand in the web", "[unit]") {
    Studied studied;
    WritingStudy study(studied.scribe, "");
    study.write_in(studied.draft);
    const auto outcome = study.write(1, {});
    REQUIRE(outcome.blocks.size() == 1);
    const WritingWays::Block& block = outcome.blocks[0];
    const test::HandMade& web = studied.web;
    const double pixel = page_of(web, kFine).pixel;  // pixels count whose middles lie within
    check_near(block.middle, web.center + 0.02 * web.right + 0.08 * web.up, pixel);
    check_near(block.right, 0.04 * web.right, pixel);
    check_near(block.up, 0.01 * web.up, pixel);
}
