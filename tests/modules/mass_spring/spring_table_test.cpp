#include "spring_table.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <tuple>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

using Ends = std::tuple<std::uint32_t, std::uint32_t, double>;

/// By the places of their ends.
std::multiset<Ends> springs_of(const Network& network, const Packing& packing) {
    std::multiset<Ends> springs;
    for (const Spring& s : network.springs) {
        const auto a = static_cast<std::uint32_t>(packing.place(s.a));
        const auto b = static_cast<std::uint32_t>(packing.place(s.b));
        springs.emplace(std::min(a, b), std::max(a, b), s.stiffness);
    }
    return springs;
}

std::multiset<Ends> springs_of(const SpringTable& table) {
    std::multiset<Ends> springs;
    for (const SpringTable::Quad& quad : table.quads) {
        for (std::uint32_t j = 0; j < 4; ++j) {
            if (quad.stiffness[j] > 0) springs.emplace(quad.a + j, quad.b + j, quad.stiffness[j]);
        }
    }
    return springs;
}

}  // namespace

TEST_CASE("every spring is in the table once", "[unit]") {
    for (const bodies::Body& body :
         {bodies::ragged_web(0.1), bodies::tangle(50, 0), bodies::shuffled(bodies::ragged_web(0))}) {
        const SpringTable table(body.network);
        CHECK(springs_of(table) == springs_of(body.network, table.packing));
        const bool damped = body.network.springs[0].damping > 0;
        CHECK(table.damping.size() == (damped ? table.quads.size() : 0));
    }
}

TEST_CASE("no two quads share a slot, and three zeros stand before and behind every run", "[unit]") {
    const bodies::Body body = bodies::ragged_web(0);
    const SpringTable table(body.network);
    std::vector<int> written(table.slots), used(table.slots);
    for (const SpringTable::Quad& quad : table.quads) {
        for (std::uint32_t j = 0; j < 4; ++j) {
            ++written.at(quad.slot + j);
            used[quad.slot + j] = quad.stiffness[j] > 0 ? 1 : 0;
        }
    }
    CHECK(*std::max_element(written.begin(), written.end()) == 1);
    for (const std::uint32_t stretch : table.incident) CHECK(stretch + 4 <= table.slots);
    for (std::size_t i = 1; i < table.quads.size(); ++i) {
        const SpringTable::Quad &quad = table.quads[i], &before = table.quads[i - 1];
        const bool goes_on = quad.slot == before.slot + 4 && quad.a == before.a + 4 && quad.b == before.b + 4;
        if (!goes_on) CHECK(used[quad.slot - 3] + used[quad.slot - 2] + used[quad.slot - 1] == 0);
    }
    CHECK(used[0] + used[1] + used[2] == 0);
    CHECK(used[table.slots - 3] + used[table.slots - 2] + used[table.slots - 1] == 0);
}

TEST_CASE("a thread is one run", "[unit]") {
    const SpringTable table(bodies::bead_string(39, 0.01, 1e-6, 1, 1e-3).network);  // 40 springs
    CHECK(table.quads.size() == 10);
    CHECK(table.quads[3].a == 12);
    CHECK(table.quads[3].b == 13);
    CHECK(table.inverse_mass.front() == 0);  // the fixed end
    CHECK(table.inverse_mass[1] == 1e6);
    CHECK(table.inverse_mass.back() == 0);  // padding
    CHECK(table.blocks.front().held == 0b0001);
    CHECK(table.blocks[1].held == 0);
    CHECK(table.blocks.back().held == 0b1111);
}

TEST_CASE("a gap shorter than a quad does not end a run", "[unit]") {
    bodies::Body body = bodies::bead_string(15, 0.01, 1e-6, 1, 1e-3);  // 16 springs
    body.network.springs.erase(body.network.springs.begin() + 5, body.network.springs.begin() + 8);
    const SpringTable table(body.network);
    CHECK(table.quads.size() == 4);
    CHECK(springs_of(table) == springs_of(body.network, table.packing));
    body.network.springs.erase(body.network.springs.begin() + 5);
    CHECK(SpringTable(body.network).quads.size() == 4);  // of 5 and of 7 springs
    CHECK(SpringTable(body.network).quads[2].a == 9);
}

TEST_CASE("particles without springs make a table too", "[unit]") {
    bodies::Body body;
    body.add({}, 2);
    const SpringTable table(body.network);
    CHECK(table.quads.empty());
    CHECK(table.incident.empty());
    CHECK(table.blocks.size() == 1);
    CHECK(table.memory_bytes() > 0);
}
