#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace orbweaver::study {

/// What something costs (s) and how wrong it is (m).
struct CostError {
    double cost = 0;
    double error = 0;
};

/// Indices of the points that no other one beats in both, by rising cost. Points with an error that is not
/// finite take no part.
std::vector<std::size_t> pareto_front(std::span<const CostError> points);

/// The cheapest point with an error of at most `bound`.
std::optional<std::size_t> cheapest_within(std::span<const CostError> points, double bound);

/// The powers of ten within which some point lies, from the smallest that contains all finite errors down to
/// the last one that contains any. Errors of 0 ask for no decade of their own.
std::vector<int> decades(std::span<const CostError> points);

}  // namespace orbweaver::study
