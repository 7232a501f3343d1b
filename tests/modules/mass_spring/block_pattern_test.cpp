#include "block_pattern.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "bodies.hpp"

using namespace orbweaver::mass_spring;

namespace {

/// Which blocks are nonzero after eliminating column by column, found on a full matrix.
std::set<std::pair<std::int32_t, std::int32_t>> eliminated(const Network& network,
                                                           const BlockPattern& pattern) {
    const auto n = static_cast<std::int32_t>(pattern.columns());
    std::set<std::pair<std::int32_t, std::int32_t>> below;
    for (const Spring& s : network.springs) {
        const auto a = pattern.column_of(s.a), b = pattern.column_of(s.b);
        if (a >= 0 && b >= 0) below.insert({std::min(a, b), std::max(a, b)});
    }
    for (std::int32_t k = 0; k < n; ++k)
        for (std::int32_t i = k + 1; i < n; ++i)
            for (std::int32_t j = k + 1; j < i; ++j)
                if (below.count({k, i}) != 0 && below.count({k, j}) != 0) below.insert({j, i});
    return below;
}

}  // namespace

TEST_CASE("the pattern holds just what elimination fills, and each column's targets", "[unit]") {
    for (bodies::Body body : {bodies::ragged_web(0), bodies::tangle(60, 0)}) {
        body.network.fixed[0] = body.network.fixed[9] = 1;
        const BlockPattern pattern(body.network);
        const auto expected = eliminated(body.network, pattern);
        CHECK(pattern.columns() == body.x.size() - 2);
        CHECK(pattern.column_of(9) == -1);
        REQUIRE(pattern.blocks() == pattern.columns() + expected.size());
        std::vector<std::pair<std::int32_t, std::int32_t>> entry(pattern.blocks());  // column, row
        for (std::size_t k = 0; k < pattern.columns(); ++k) {
            const auto column = static_cast<std::int32_t>(k);
            entry[k] = {column, column};
            for (std::size_t i = 0; i < pattern.rows(k).size(); ++i) {
                entry[pattern.first_block(k) + i] = {column, pattern.rows(k)[i]};
                CHECK(expected.count({column, pattern.rows(k)[i]}) == 1);
            }
        }
        std::size_t next = 0;
        for (std::size_t k = 0; k < pattern.columns(); ++k) {
            const auto rows = pattern.rows(k);
            for (std::size_t j = 0; j < rows.size(); ++j)
                for (std::size_t i = j; i < rows.size(); ++i) {
                    const auto target = static_cast<std::size_t>(pattern.targets()[next++]);
                    CHECK(entry[target] == std::pair(rows[j], rows[i]));
                }
        }
        CHECK(next == pattern.targets().size());
        CHECK(pattern.memory_bytes() > 0);
    }
}

TEST_CASE("a pattern is made within its limit to the block and to the update, and not beyond", "[unit]") {
    for (const bodies::Body& body : {bodies::ragged_web(0), bodies::tangle(60, 0), bodies::lattice(8, 0.1)}) {
        const BlockPattern whole(body.network);
        const FactorLimit just{whole.blocks(), whole.targets().size()};
        const auto within = BlockPattern::within(body.network, just);
        REQUIRE(within);
        CHECK(within->blocks() == whole.blocks());
        CHECK(std::equal(within->targets().begin(), within->targets().end(), whole.targets().begin(),
                         whole.targets().end()));
        CHECK_FALSE(BlockPattern::within(body.network, {just.blocks - 1, just.updates}));
        CHECK_FALSE(BlockPattern::within(body.network, {just.blocks, just.updates - 1}));
    }
}

TEST_CASE("a thread fills nothing", "[unit]") {
    const BlockPattern pattern(bodies::bead_string(50, 0.01, 1, 1, 0.1).network);
    CHECK(pattern.columns() == 50);
    CHECK(pattern.blocks() == 50 + 49);
}
