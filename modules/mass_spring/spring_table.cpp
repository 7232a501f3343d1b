#include "spring_table.hpp"

#include <algorithm>
#include <tuple>

#include "numbering.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr std::uint32_t kLanes = Packing::kLanes;

/// A spring with the places of its ends in ascending order. Its force does not depend on which end is called a.
struct Link {
    std::uint32_t a;
    std::uint32_t offset;  ///< from a to b
    std::uint32_t spring;
};

/// Links [first, end) of one offset, over `length` particles from the first one's a on.
struct Run {
    std::size_t first;
    std::size_t end;
    std::uint32_t length;
    std::uint32_t slot;
};

std::vector<Link> links_by_offset(const Network& network, const Packing& packing) {
    std::vector<Link> links;
    links.reserve(network.springs.size());
    for (std::uint32_t i = 0; i < network.springs.size(); ++i) {
        const auto at = [&](std::uint32_t end) { return static_cast<std::uint32_t>(packing.place(end)); };
        const std::uint32_t one = at(network.springs[i].a), other = at(network.springs[i].b);
        const auto [a, b] = std::minmax(one, other);
        links.push_back({a, b - a, i});
    }
    std::sort(links.begin(), links.end(), [](const Link& p, const Link& q) {
        return std::tie(p.offset, p.a, p.spring) < std::tie(q.offset, q.a, q.spring);
    });
    return links;
}

/// In the order of their first particles, so that what is used together lies together. A gap costs less than
/// a new run while it is shorter than a quad.
std::vector<Run> find_runs(const std::vector<Link>& links) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < links.size(); ++i) {
        const bool goes_on = i > 0 && links[i].offset == links[i - 1].offset && links[i].a != links[i - 1].a &&
                             links[i].a <= links[i - 1].a + kLanes;
        if (!goes_on) runs.push_back({i, i, 0, 0});
        runs.back().end = i + 1;
        runs.back().length = links[i].a - links[runs.back().first].a + 1;
    }
    std::stable_sort(runs.begin(), runs.end(),
                     [&](const Run& p, const Run& q) { return links[p.first].a < links[q.first].a; });
    return runs;
}

std::size_t count_quads(const Network& network, const Packing& packing) {
    std::size_t quads = 0;
    for (const Run& run : find_runs(links_by_offset(network, packing)))
        quads += (run.length + kLanes - 1) / kLanes;
    return quads;
}

/// The network's own order where springs come in runs so: at two springs a quad half of the gain is there.
/// Otherwise that along threads, where it makes a difference.
Packing choose_packing(const Network& network) {
    constexpr double kSpringsAQuad = 2, kWorthIt = 0.75;
    Packing own(network.size());
    const auto quads = static_cast<double>(count_quads(network, own));
    if (network.driven || kSpringsAQuad * quads <= static_cast<double>(network.springs.size())) return own;
    Packing along_threads(number_along_threads(network));
    const bool worth_it = static_cast<double>(count_quads(network, along_threads)) < kWorthIt * quads;
    return worth_it ? along_threads : own;
}

constexpr std::uint32_t round_up(std::uint32_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

void add_quads(const std::vector<Link>& links, const Run& run, SpringTable& table) {
    const Link& start = links[run.first];
    const auto base = static_cast<std::uint32_t>(table.quads.size()) * kLanes;
    for (std::uint32_t i = 0; i < run.length; i += kLanes)
        table.quads.push_back({start.a + i, start.a + i + start.offset, run.slot + i, {}, {}});
    for (std::size_t i = run.first; i < run.end; ++i)
        table.place[links[i].spring] = base + links[i].a - start.a;
}

void fill_constants(const std::vector<Spring>& springs, SpringTable& table) {
    for (std::size_t i = 0; i < springs.size(); ++i) {
        SpringTable::Quad& quad = table.quads[table.place[i] / kLanes];
        quad.rest_length[table.place[i] % kLanes] = springs[i].rest_length;
        quad.stiffness[table.place[i] % kLanes] = springs[i].stiffness;
    }
}

void fill_damping(const std::vector<Spring>& springs, SpringTable& table) {
    table.damping.resize(table.quads.size());
    for (std::size_t i = 0; i < springs.size(); ++i)
        table.damping[table.place[i] / kLanes][table.place[i] % kLanes] = springs[i].damping;
}

void fill_laws(const std::vector<Spring>& springs, SpringTable& table) {
    table.laws.resize(table.quads.size());
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const std::uint32_t lane = table.place[i] % kLanes;
        const MaterialLaw& from = springs[i].law;
        SpringTable::Law& law = table.laws[table.place[i] / kLanes];
        law.softening[lane] = from.softening;
        law.stiffening[lane] = from.stiffening;
        law.arm[lane] = from.arm;
        law.relaxation_rate[lane] = from.arm > 0 ? 1 / from.relaxation_time : 0;
    }
}

/// The stretches of slots that pull at each block.
using Stretches = std::vector<std::vector<std::uint32_t>>;

/// Those of a run whose ends (all a, or all b) are the `run.length` particles from `end` on.
void add_stretches(const Run& run, std::uint32_t end, Stretches& stretches) {
    for (std::uint32_t block = end / kLanes; block <= (end + run.length - 1) / kLanes; ++block)
        stretches[block].push_back(run.slot + block * kLanes - end);
}

void list_incident(const Stretches& as_a, const Stretches& as_b, SpringTable& table) {
    const auto append = [&](const std::vector<std::uint32_t>& stretches) {
        table.incident.insert(table.incident.end(), stretches.begin(), stretches.end());
        return static_cast<std::uint32_t>(table.incident.size());
    };
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < as_a.size(); ++i) {
        const std::uint32_t first_as_b = append(as_a[i]);
        const std::uint32_t end = append(as_b[i]);
        table.blocks.push_back({first, first_as_b, end, 0});
        first = end;
    }
}

}  // namespace

SpringTable::SpringTable(const Network& network)
    : packing(choose_packing(network)), place(network.springs.size()), inverse_mass(packing.plane()) {
    const std::vector<Link> links = links_by_offset(network, packing);
    std::vector<Run> runs = find_runs(links);
    Stretches as_a(packing.blocks()), as_b(packing.blocks());
    std::uint32_t slot = kLanes;  // a stretch may begin before its run, and end behind it
    for (Run& run : runs) {
        run.slot = slot;
        slot += round_up(run.length + kLanes - 1);  // at least three zeros
        add_quads(links, run, *this);
        add_stretches(run, links[run.first].a, as_a);
        add_stretches(run, links[run.first].a + links[run.first].offset, as_b);
    }
    slots = slot;
    list_incident(as_a, as_b, *this);
    fill_constants(network.springs, *this);
    if (is_damped(network)) fill_damping(network.springs, *this);
    if (is_curved(network) || has_arms(network)) fill_laws(network.springs, *this);
    if (!has_arms(network) && !network.driven) place = {};
    for (std::size_t i = 0; i < network.size(); ++i)
        inverse_mass[packing.place(i)] = network.fixed[i] != 0 ? 0 : 1 / network.mass[i];
    for (std::size_t i = 0; i < inverse_mass.size(); ++i) {
        if (inverse_mass[i] == 0) blocks[i / kLanes].held |= 1U << (i % kLanes);
    }
}

std::size_t SpringTable::memory_bytes() const noexcept {
    return quads.capacity() * sizeof(Quad) + blocks.capacity() * sizeof(Block) +
           incident.capacity() * sizeof(std::uint32_t) + damping.capacity() * Packing::kLanes * sizeof(double) +
           laws.capacity() * sizeof(Law) + place.capacity() * sizeof(std::uint32_t) +
           inverse_mass.capacity() * sizeof(double) + packing.memory_bytes();
}

}  // namespace orbweaver::mass_spring
