#include "numbering.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "bodies.hpp"
#include "spring_table.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// A net of rows x columns.
Body net(std::uint32_t rows, std::uint32_t columns) {
    Body body;
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const auto i = body.add({0.01 * x, 0.01 * y, 0}, 1e-6);
            if (x > 0) body.join(i - 1, i, 0.01, 1);
            if (y > 0) body.join(i - columns, i, 0.01, 1);
        }
    return body;
}

bool is_permutation_of_all(std::vector<std::uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::uint32_t> all(numbers.size());
    std::iota(all.begin(), all.end(), 0U);
    return numbers == all;
}

}  // namespace

TEST_CASE("every particle has one number, in pieces, loops and knots too", "[unit]") {
    Body pieces = bodies::bead_string(3, 0.01, 1e-6, 1, 1e-3);
    pieces.add({1, 0, 0}, 1);  // lone
    pieces.add({2, 0, 0}, 1);
    pieces.join(5, 6, 1, 1);
    pieces.join(6, 5, 1, 1);  // twice
    for (const Body& body : {pieces, bodies::ragged_web(0), bodies::tangle(60, 0), bodies::shuffled(net(7, 9)),
                             bodies::lattice(4, 0.1), bodies::oscillator(1, 1)})
        CHECK(is_permutation_of_all(number_along_threads(body.network)));
    CHECK(number_along_threads(Network{}).empty());
}

TEST_CASE("a thread and a net are found again, whatever their particles' numbers", "[unit]") {
    const SpringTable thread(bodies::shuffled(bodies::bead_string(398, 0.01, 1e-6, 1, 1e-3)).network);
    CHECK(thread.quads.size() == 100);  // of 399 springs
    const SpringTable mixed(bodies::shuffled(net(30, 30)).network);
    CHECK(4 * mixed.quads.size() < 1.1 * 2 * 30 * 29);
}

TEST_CASE("what comes in runs, or never does, keeps its numbers", "[unit]") {
    for (const Body& body :
         {bodies::bead_string(50, 0.01, 1e-6, 1, 1e-3), net(20, 20), bodies::wheel(50, 1, 1, 0)}) {
        const SpringTable table(body.network);
        for (std::size_t i = 0; i < body.x.size(); ++i) REQUIRE(table.packing.place(i) == i);
    }
}
