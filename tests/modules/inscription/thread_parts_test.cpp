#include "thread_parts.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "dilate.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

struct Run {
    double from, to;
    bool dark;
};

/// Of darkness and brightness along a line: cut wherever a column or a row of pixels begins.
std::vector<Run> runs_of(const Bitmap& bitmap, const Spot& a, const Spot& b) {
    std::vector<double> cuts = {0, 1};
    for (double side = -20; side <= 80; ++side) {
        cuts.push_back(std::clamp((side - a.x) / (b.x - a.x), 0.0, 1.0));
        cuts.push_back(std::clamp((side - a.y) / (b.y - a.y), 0.0, 1.0));
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<Run> runs;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
        const double x = std::lerp(a.x, b.x, middle), y = std::lerp(a.y, b.y, middle);
        const bool seen = x >= 0 && y >= 0 && x < bitmap.width && y < bitmap.height;
        const bool dark = seen && bitmap.row(static_cast<std::uint32_t>(y))[static_cast<std::uint32_t>(x)] != 0;
        if (cuts[i] == cuts[i - 1]) continue;
        if (runs.empty() || runs.back().dark != dark) runs.push_back({cuts[i - 1], 1, dark});
        runs.back().to = cuts[i];
    }
    return runs;
}

double covered(const std::vector<Part>& parts, const Run& run) {
    double sum = 0;
    for (const Part& part : parts)
        sum += std::max(std::min(part.to, run.to) - std::max(part.from, run.from), 0.0);
    return sum;
}

/// One row, and a thread along its middle.
std::vector<Part> parts_of_row(std::string_view row, double shortest) {
    return dark_parts(test::drawn({row}), {0, 0.5}, {static_cast<double>(row.size()), 0.5}, shortest);
}

}  // namespace

TEST_CASE("parts are in order, apart, and neither they nor what is left is too short", "[unit]") {
    std::size_t parts_seen = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const RandomStream random(seed, "thread");
        const Bitmap bitmap =
            dilate(test::random_bitmap(60, 60, random.uniform(0, 0.001, 0.2), seed), seed % 2 == 0 ? 1 : 5);
        const Spot a{random.uniform(1, -10, 70), random.uniform(2, -10, 70)};
        const Spot b{random.uniform(3, -10, 70), random.uniform(4, -10, 70)};
        const double length = std::hypot(b.x - a.x, b.y - a.y), shortest = random.uniform(5, 0.5, 12);
        const double least = shortest / length;
        const auto parts = dark_parts(bitmap, a, b, shortest);
        parts_seen += parts.size();
        const auto runs = runs_of(bitmap, a, b);
        constexpr double kRounding = 1e-9;  // crossings closer than that count as one
        if (length < 2 * shortest) {
            double dark = 0;
            for (const Run& run : runs) dark += run.dark ? run.to - run.from : 0;
            REQUIRE(parts.size() == (dark > 0.5 ? 1 : 0));
            if (!parts.empty()) CHECK((parts[0].from == 0 && parts[0].to == 1));
            continue;
        }
        double at = 0;
        for (const Part& part : parts) {
            CHECK(part.to - part.from >= least - kRounding);
            CHECK((part.from == at || part.from - at >= least - kRounding));
            CHECK((part.from > at || at == 0));
            at = part.to;
        }
        CHECK((at == 1 || 1 - at >= least - kRounding));
        for (const Run& run : runs) {
            const double size = run.to - run.from;
            if (size < least + kRounding) continue;
            CHECK(covered(parts, run) == Approx(run.dark ? size : 0).margin(kRounding));
        }
    }
    CHECK(parts_seen > 200);
}

TEST_CASE("parts begin and end where pixels do", "[unit]") {
    const auto parts = parts_of_row("...####.....####....", 3);
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].from == Approx(3 / 20.0).margin(1e-12));
    CHECK(parts[0].to == Approx(7 / 20.0).margin(1e-12));
    CHECK(parts[1].from == Approx(12 / 20.0).margin(1e-12));
    CHECK(parts[1].to == Approx(16 / 20.0).margin(1e-12));
}

TEST_CASE("what is bright for less than the shortest part is overlooked, and so what is dark", "[unit]") {
    const auto bridged = parts_of_row("......###..###......", 3);
    REQUIRE(bridged.size() == 1);
    CHECK(bridged[0].from == Approx(0.3).margin(1e-12));
    CHECK(bridged[0].to == Approx(0.7).margin(1e-12));
    CHECK(parts_of_row("......##............", 3).empty());
    const auto to_the_ends = parts_of_row("..####........####..", 3);
    REQUIRE(to_the_ends.size() == 2);
    CHECK(to_the_ends[0].from == 0);
    CHECK(to_the_ends[1].to == 1);
}

TEST_CASE("threads that are all dark, all bright or of no length", "[unit]") {
    const auto all = parts_of_row("##########", 2);
    REQUIRE(all.size() == 1);
    CHECK(all[0].from == 0);
    CHECK(all[0].to == 1);
    CHECK(parts_of_row("..........", 2).empty());
    CHECK(parts_of_row("..........", 20).empty());
    CHECK(dark_parts(test::drawn({"#"}), {0.5, 0.5}, {0.5, 0.5}, 1).empty());
}
