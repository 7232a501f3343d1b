#include "numbering.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace orbweaver::mass_spring {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The neighbors of each particle, in ascending order, each once.
class Neighbors {
public:
    explicit Neighbors(const Network& network) : begin_(network.size() + 1) {
        std::vector<std::uint64_t> pairs;
        pairs.reserve(2 * network.springs.size());
        for (const Spring& s : network.springs) {
            if (s.a == s.b) continue;
            pairs.push_back(std::uint64_t{s.a} << 32U | s.b);
            pairs.push_back(std::uint64_t{s.b} << 32U | s.a);
        }
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        for (const std::uint64_t pair : pairs) {
            ++begin_[(pair >> 32U) + 1];
            all_.push_back(static_cast<std::uint32_t>(pair));
        }
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    }

    std::span<const std::uint32_t> of(std::uint32_t i) const noexcept {
        return std::span(all_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
    }
    bool are(std::uint32_t i, std::uint32_t j) const noexcept {
        const auto near = of(i);
        return std::binary_search(near.begin(), near.end(), j);
    }
    /// Whether some particle other than `corner` is a neighbor of both: then they lie around a mesh's corner.
    bool meet_beside(std::uint32_t i, std::uint32_t j, std::uint32_t corner) const noexcept {
        const auto near = of(i);
        return std::any_of(near.begin(), near.end(), [&](std::uint32_t k) { return k != corner && are(k, j); });
    }

private:
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> all_;
};

class Numbering {
public:
    explicit Numbering(const Network& network) : near_(network), number_(network.size(), kNone) {}

    std::vector<std::uint32_t> number() {
        std::vector<std::uint32_t> from(number_.size());
        std::iota(from.begin(), from.end(), 0U);
        // Where fewest springs end, threads do.
        std::stable_sort(from.begin(), from.end(), [&](std::uint32_t i, std::uint32_t j) {
            return near_.of(i).size() < near_.of(j).size();
        });
        for (const std::uint32_t start : from) {
            if (number_[start] != kNone) continue;
            for (auto line = walk(start); !line.empty(); line = beside(line)) {
            }
        }
        return std::move(number_);
    }

private:
    using Line = std::vector<std::uint32_t>;

    void add(std::uint32_t particle, Line& line) {
        number_[particle] = next_++;
        line.push_back(particle);
    }

    /// On from `start` as far as there is something without a number, straight on where that can be.
    Line walk(std::uint32_t start) {
        Line line;
        add(start, line);
        for (std::uint32_t before = kNone, here = start;;) {
            std::uint32_t next = kNone;
            for (const std::uint32_t i : near_.of(here)) {
                if (number_[i] != kNone) continue;
                const bool straight = before != kNone && !near_.meet_beside(before, i, here);
                if (next == kNone || straight) next = i;
                if (straight) break;
            }
            if (next == kNone) return line;
            add(next, line);
            before = here;
            here = next;
        }
    }

    /// A neighbor without a number of each of the line's: best one that lies beside the last one found, then
    /// one beside which the next will be.
    Line beside(const Line& line) {
        Line found;
        for (std::size_t k = 0; k < line.size(); ++k) {
            std::uint32_t next = kNone;
            int most = 0;
            for (const std::uint32_t j : near_.of(line[k])) {
                if (number_[j] != kNone) continue;
                const bool goes_on = !found.empty() && near_.are(found.back(), j);
                const bool leads_on = k + 1 < line.size() && near_.meet_beside(j, line[k + 1], line[k]);
                const int worth = 1 + 2 * static_cast<int>(goes_on) + static_cast<int>(leads_on);
                if (worth > most) next = j;
                most = std::max(most, worth);
            }
            if (next != kNone) add(next, found);
        }
        return found;
    }

    Neighbors near_;
    std::vector<std::uint32_t> number_;
    std::uint32_t next_ = 0;
};

}  // namespace

std::vector<std::uint32_t> number_along_threads(const Network& network) { return Numbering(network).number(); }

}  // namespace orbweaver::mass_spring
