#pragma once

#include <string>
#include <vector>

#include "orbweaver/contracts/surface_ways.hpp"
#include "study/study_settings.hpp"
#include "study/time_budget.hpp"

namespace orbweaver::study {

/// How one way of asking did with one kind of questions.
struct QueryRow {
    std::string questions;  ///< "vertices"
    std::string way;        ///< "wide_tree"
    std::size_t asked = 0;
    std::size_t missed = 0;     ///< nothing found where there is something
    std::size_t invented = 0;   ///< something found where there is nothing
    double error_m = 0;         ///< m, largest distance of a place found from where it should be
    double median_error_m = 0;  ///< m
    double cost_s = 0;          ///< s a question, median of the timed passes
};

/// What a study of queries found.
struct QueryResult {
    struct Named {
        std::string name;
        std::string meaning;
    };

    std::string scene;
    std::size_t triangles = 0;
    double size_m = 0;        ///< m, largest extent of the surface
    std::uint64_t seed = 0;   ///< of the questions
    std::vector<Named> sets;  ///< kinds of questions
    std::vector<Named> ways;  ///< ways of asking
    std::vector<QueryRow> rows;
    std::vector<std::string> sentences;  ///< what it comes to

    /// The rows of one kind of questions.
    std::vector<QueryRow> rows_of(const std::string& questions) const;
};

/// Asks a surface the same questions by every way that is offered, and holds the answers against a reference of
/// its own. Throws Fault(invalid) for settings.methods that name no way, Fault(limit) when a way has no memory.
QueryResult study_queries(const StudySettings& settings, const std::string& scene, std::uint64_t seed,
                          const Surface& surface, const std::vector<SurfaceWays*>& offers,
                          const Deadline& deadline);

}  // namespace orbweaver::study
