#include "source_picture.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "line.hpp"
#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// One thread level through the middle of row 20 of 40, from pixel 0 to pixel 39; another upright at the right.
test::HandMade two_threads() {
    test::HandMade web;
    web.points = {{0, 19.5, 0}, {40, 19.5, 0}, {35.5, 0, 0}, {35.5, 40, 0}};
    web.join(0, 1, test::kSpiral);
    web.join(2, 3, test::kAnchor);
    return web;
}

}  // namespace

TEST_CASE("the source picture has threads of all kinds, three pixels to each side of a line", "[unit]") {
    const test::HandMade web = two_threads();
    const Bitmap picture = source_picture(web, page_of(web, 40));
    for (std::uint32_t y = 0; y < 40; ++y)
        for (std::uint32_t x = 0; x < 40; ++x)
            CHECK(picture.row(y)[x] == ((y >= 17 && y <= 23) || (x >= 32 && x <= 38) ? 1 : 0));
}

TEST_CASE("every pixel is dark that has a thread's line within three pixels, and no other", "[unit]") {
    const test::HandMade web = test::random_web(20, 15, 3);
    const Page page = page_of(web, 70);
    Bitmap lines(70, 70);
    for (const ThreadSegment& thread : web.segments)
        draw_line(lines, page.spot(web.points[thread.a]), page.spot(web.points[thread.b]));
    const Bitmap picture = source_picture(web, page);
    for (std::uint32_t y = 0; y < 70; ++y)
        for (std::uint32_t x = 0; x < 70; ++x) {
            const Box around{x - std::min(x, 3U), y - std::min(y, 3U), std::min(x + 4, 70U),
                             std::min(y + 4, 70U)};
            CHECK(picture.row(y)[x] == (dark_box(lines.values, 70, around).empty() ? 0 : 1));
        }
}

TEST_CASE("threads to be added are drawn as if the web had them", "[unit]") {
    const test::HandMade web = two_threads();
    const std::vector<WebChange::Added> added = {{0, 3, 0, 2.5}};
    const test::HandMade with = test::changed(web, {{}, added, {}});
    const Page page = page_of(web, 40);
    CHECK(source_picture(web, page, added) == source_picture(with, page));
    CHECK_FALSE(source_picture(web, page, added) == source_picture(web, page));
}
