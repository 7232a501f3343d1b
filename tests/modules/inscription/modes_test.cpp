#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <sstream>

#include "bitmaps.hpp"
#include "mode.hpp"
#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// Words a few meshes high above the hub, and a bar below it.
Bitmap words() {
    Bitmap coverage(200, 200);
    test::fill(coverage, {60, 30, 75, 75});
    test::fill(coverage, {75, 60, 140, 75});
    test::fill(coverage, {50, 130, 150, 150});
    return coverage;
}

void check_sound(const WebChange& change, const test::HandMade& web) {
    std::set<std::uint32_t> removed;
    for (const std::uint32_t i : change.removed) {
        REQUIRE(i < web.segments.size());
        CHECK(removed.insert(i).second);
    }
    for (const WebChange::Added& thread : change.added) {
        REQUIRE((thread.a < web.points.size() && thread.b < web.points.size()));
        CHECK(distance(web.points[thread.a], web.points[thread.b]) > 0);
        REQUIRE(thread.like < web.segments.size());
        CHECK(thread.width > 0);
    }
    std::vector<WebChange::Thickened> parts = change.thickened;
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.segment < b.segment; });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        REQUIRE(parts[i].segment < web.segments.size());
        CHECK_FALSE(removed.contains(parts[i].segment));
        CHECK((parts[i].from >= 0 && parts[i].from < parts[i].to && parts[i].to <= 1));
        CHECK(parts[i].width > 0);
        if (i > 0 && parts[i - 1].segment == parts[i].segment) CHECK(parts[i - 1].to <= parts[i].from);
    }
}

bool same(const WebChange& one, const WebChange& other) {
    return one.removed == other.removed &&
           std::equal(one.added.begin(), one.added.end(), other.added.begin(), other.added.end(),
                      [](const auto& a, const auto& b) {
                          return a.a == b.a && a.b == b.b && a.like == b.like && a.width == b.width;
                      }) &&
           std::equal(one.thickened.begin(), one.thickened.end(), other.thickened.begin(),
                      other.thickened.end(), [](const auto& a, const auto& b) {
                          return a.segment == b.segment && a.from == b.from && a.to == b.to &&
                                 a.width == b.width;
                      });
}

}  // namespace

TEST_CASE("each mode is found by its name, and nothing by another", "[unit]") {
    CHECK(modes().size() == 6);
    for (const Mode& mode : modes()) {
        CHECK(find_mode(mode.name) == &mode);
        CHECK_FALSE(mode.meaning.empty());
        CHECK(mode.write != nullptr);
    }
    CHECK(find_mode("") == nullptr);
    CHECK(find_mode("Removal") == nullptr);
    CHECK(find_mode("remova") == nullptr);
}

TEST_CASE("a scene may choose all modes and no others", "[unit]") {
    std::ifstream file(std::string(ORBWEAVER_SOURCE_DIR) + "/modules/inscription/manifest.toml");
    std::stringstream manifest;
    manifest << file.rdbuf();
    std::string choices;
    for (const Mode& mode : modes())
        choices += (choices.empty() ? "" : ", ") + ('"' + std::string(mode.name) + '"');
    CHECK(manifest.str().find("[options.mode]\ntype = \"choice\"\ndefault = \"legible\"\nchoices = [" +
                              choices + "]") != std::string::npos);
}

TEST_CASE("every mode writes something that a web can be changed by, and the same again", "[unit]") {
    const test::HandMade web = test::make_orb(32, 16);
    const Page page = page_of(web, 200);
    for (const Mode& mode : modes()) {
        const test::Task task{web, page, words(), {.score_threshold = 5, .attachments = 0.5}};
        const WebChange change = task.write(mode.write);
        CHECK(change.removed.size() + change.added.size() + change.thickened.size() > 0);
        check_sound(change, web);
        CHECK(same(change, task.write(mode.write)));
    }
}

TEST_CASE("no mode touches a web for a blank target", "[unit]") {
    const test::HandMade web = test::make_orb(24, 10);
    for (const Mode& mode : modes())
        CHECK(same(test::Task{web, page_of(web, 100), Bitmap(100, 100), {}}.write(mode.write), {}));
}
