#include "gait.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

using namespace orbweaver::crawler;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr Effort kAll{0.1, 20, 30, 5};

std::vector<Flex> flexes(std::string_view gait, double waves, std::uint32_t segments, double cycles,
                         const Effort& effort = kAll, WaveForm form = WaveForm::sine) {
    std::vector<Flex> flexes(segments, Flex{9, 9, 9});
    Waves(*find_gait(gait), form, waves, segments).flex(cycles, effort, flexes);
    return flexes;
}

double wave(double waves, std::uint32_t segments, std::size_t i, int way, double cycles) {
    return std::cos(2 * kPi * (waves * (static_cast<double>(i) + 0.5) / segments + way * cycles));
}

}  // namespace

TEST_CASE("gaits are found by their names, others are not, and each says what it means", "[unit]") {
    for (const Gait& gait : gaits()) {
        CHECK(find_gait(gait.name) == &gait);
        CHECK_FALSE(gait.meaning.empty());
    }
    for (const char* name : {"rectilinear", "undulation", "sidewinding", "caterpillar"})
        CHECK(find_gait(name) != nullptr);
    for (const char* name : {"", "rect", "rectilinear ", "Undulation"}) CHECK(find_gait(name) == nullptr);
}

TEST_CASE("waves of every gait are what its cosines say, in its channels alone", "[unit]") {
    for (const std::uint32_t segments : {2U, 7U, 40U})
        for (const double waves : {0.5, 1.0, 1.4, 3.0})
            for (const double cycles : {0.0, 0.3, 0.95, 17.625, -2.2}) {
                const auto worm = flexes("rectilinear", waves, segments, cycles);
                const auto snake = flexes("undulation", waves, segments, cycles);
                const auto winder = flexes("sidewinding", waves, segments, cycles);
                const auto caterpillar = flexes("caterpillar", waves, segments, cycles);
                // Angles of some 100 radians are rounded by 1e-14 before their cosine is taken.
                const double rounding = 1e-13;
                for (std::size_t i = 0; i < segments; ++i) {
                    const double down = wave(waves, segments, i, 1, cycles);
                    const double on = wave(waves, segments, i, -1, cycles);
                    CHECK(worm[i].strain == Approx(0.1 * down).margin(0.1 * rounding));
                    CHECK(worm[i].side == 5);
                    CHECK(worm[i].up == 0);
                    CHECK(snake[i].strain == 0);
                    CHECK(snake[i].side == Approx(5 + 20 * down).margin(20 * rounding));
                    CHECK(snake[i].up == 0);
                    CHECK(winder[i].strain == 0);
                    CHECK(winder[i].side == Approx(5 + 20 * down).margin(20 * rounding));
                    // A quarter later.
                    const double later = wave(waves, segments, i, 1, cycles - 0.25);
                    CHECK(winder[i].up == Approx(30 * later).margin(30 * rounding));
                    CHECK(caterpillar[i].strain == Approx(0.1 * on).margin(0.1 * rounding));
                    CHECK(caterpillar[i].side == 5);
                    CHECK(caterpillar[i].up == Approx(30 * on).margin(30 * rounding));
                }
            }
}

TEST_CASE("waves run towards the tail, but those of caterpillars towards the head", "[unit]") {
    const std::uint32_t segments = 30;
    const double waves = 2, a_segment = waves / segments;  // cycles that a wave takes for one
    for (const Gait& gait : gaits()) {
        const bool to_head = gait.name == "caterpillar";
        const auto now = flexes(gait.name, waves, segments, 0.37);
        const auto then = flexes(gait.name, waves, segments, 0.37 + a_segment);
        for (std::size_t i = 1; i < segments; ++i) {
            const Flex& from = now[to_head ? i - 1 : i];
            const Flex& to = then[to_head ? i : i - 1];
            CHECK(to.strain == Approx(from.strain).margin(1e-13));
            CHECK(to.side == Approx(from.side).margin(1e-12));
            CHECK(to.up == Approx(from.up).margin(1e-12));
        }
    }
}

TEST_CASE("a caterpillar is highest where it is shortest", "[unit]") {
    const std::uint32_t segments = 200;
    for (const double cycles : {0.1, 0.35, 0.8}) {
        const auto flex = flexes("caterpillar", 2, segments, cycles, {0.1, 0, 10, 0});
        // Curvature upwards is how the slope grows along the body: heights by two sums, less the straight line
        // that they are determined but for. One wavelength, from its middle, where the wave's sums are even.
        const std::size_t length = segments / 2;
        std::vector<double> height(2 * length);
        double slope = 0, y = 0;
        for (std::size_t i = 0; i < 2 * length; ++i) {
            slope += flex[i].up / segments;
            y += slope / segments;
            height[i] = y;
        }
        const double drift = (height[2 * length - 1] - height[length - 1]) / static_cast<double>(length);
        for (std::size_t i = 0; i < 2 * length; ++i) height[i] -= drift * static_cast<double>(i);
        const auto top = std::max_element(height.begin() + 20, height.begin() + 20 + 100) - height.begin();
        const auto shortest =
            std::min_element(flex.begin() + 20, flex.begin() + 20 + 100,
                             [](const Flex& a, const Flex& b) { return a.strain < b.strain; }) -
            flex.begin();
        CHECK(std::abs(top - shortest) <= 3);  // of a wavelength of 100; sums lag by a segment
    }
}

TEST_CASE("a square wave is the sign of the sine wave, nowhere zero", "[unit]") {
    for (const Gait& gait : gaits())
        for (const double cycles : {0.0, 0.25, 0.5, 0.61}) {
            const auto sine = flexes(gait.name, 1.3, 24, cycles, {1, 1, 1, 0});
            const auto square = flexes(gait.name, 1.3, 24, cycles, {0.1, 20, 30, 0}, WaveForm::square);
            const auto check = [](bool has, double from, double to, double size) {
                if (!has) CHECK(to == 0);
                if (has) CHECK(std::abs(to) == size);
                if (has && std::abs(from) > 1e-12) CHECK(to * from > 0);
            };
            for (std::size_t i = 0; i < 24; ++i) {
                check(gait.strains, sine[i].strain, square[i].strain, 0.1);
                check(gait.bends, sine[i].side, square[i].side, 20);
                check(gait.lifts, sine[i].up, square[i].up, 30);
            }
        }
}

TEST_CASE("a cycle later muscles are told the same, to the bit", "[unit]") {
    for (const Gait& gait : gaits())
        for (const double share : {0.0, 0.25, 0.40625, 0.875})  // that so many cycles do not round
            for (const double cycles : {1.0, 3.0, 1073741824.0, -4.0}) {
                const auto now = flexes(gait.name, 1.4, 13, share);
                const auto then = flexes(gait.name, 1.4, 13, share + cycles);
                for (std::size_t i = 0; i < 13; ++i) {
                    CHECK(now[i].strain == then[i].strain);
                    CHECK(now[i].side == then[i].side);
                    CHECK(now[i].up == then[i].up);
                }
            }
}

TEST_CASE("without effort a body is straight, and turning alone bends it everywhere alike", "[unit]") {
    for (const Gait& gait : gaits())
        for (const double turn : {0.0, 3.0, -2.0})
            for (const Flex& each : flexes(gait.name, 2, 12, 0.4, {0, 0, 0, turn})) {
                CHECK(each.strain == 0);
                CHECK(each.side == turn);
                CHECK(each.up == 0);
            }
}
