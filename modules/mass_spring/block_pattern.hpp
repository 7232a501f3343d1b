#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "network.hpp"

namespace orbweaver::mass_spring {

/// The most that a factor may take.
struct FactorLimit {
    std::size_t blocks = std::numeric_limits<std::size_t>::max();   ///< that elimination leaves nonzero
    std::size_t updates = std::numeric_limits<std::size_t>::max();  ///< of blocks by blocks: its work
};

/// Where the 3x3 blocks of a network's symmetric matrix and of its Cholesky factor lie: a column for every free
/// particle, ordered by approximate minimum degree (Amestoy, Davis and Duff 1996). The diagonal blocks come
/// first, one per column; below them, column by column, those that elimination leaves nonzero.
class BlockPattern {
public:
    /// However large.
    explicit BlockPattern(const Network& network);
    /// Nothing where the factor would take more. That is counted while columns are eliminated in name only, and
    /// found before anything but the rows of the blocks so far takes memory.
    static std::optional<BlockPattern> within(const Network& network, const FactorLimit& limit);

    /// Where a spring's block is added: at the diagonals of its ends, and beside them. -1: the end is fixed.
    struct Place {
        std::int32_t a = -1;  ///< the further up
        std::int32_t b = -1;
        std::int32_t beside = -1;
    };

    std::size_t columns() const noexcept { return begins_.size() - 1; }
    std::size_t blocks() const noexcept { return columns() + rows_.size(); }
    std::int32_t column_of(std::size_t particle) const noexcept { return columns_[particle]; }  ///< -1: fixed
    std::span<const Place> places() const noexcept { return places_; }
    /// The rows below the diagonal of a column, ascending, and the first one's block.
    std::span<const std::int32_t> rows(std::size_t column) const noexcept {
        return {rows_.data() + begins_[column], rows_.data() + begins_[column + 1]};
    }
    std::size_t first_block(std::size_t column) const noexcept { return columns() + begins_[column]; }
    /// The blocks (i, j) that eliminating columns 0, 1, ... changes, in that order: for every j of rows(k), for
    /// every i >= j of rows(k).
    std::span<const std::int32_t> targets() const noexcept { return targets_; }
    std::size_t memory_bytes() const noexcept;

private:
    using Neighbors = std::vector<std::vector<std::int32_t>>;  ///< per column, rows below

    BlockPattern() = default;
    /// False where it takes more; then nothing else of it holds.
    bool build(const Network& network, const FactorLimit& limit);
    void order(const Network& network);
    Neighbors joined(const Network& network) const;
    bool fill_in(Neighbors below, const FactorLimit& limit);
    void list_targets();
    void place_springs(const Network& network);
    std::int32_t block_at(std::int32_t row, std::int32_t column) const noexcept;

    std::vector<std::int32_t> columns_;  ///< of each particle
    std::vector<std::size_t> begins_{0};
    std::vector<std::int32_t> rows_;
    std::size_t updates_ = 0;
    std::vector<std::int32_t> targets_;
    std::vector<Place> places_;
};

}  // namespace orbweaver::mass_spring
