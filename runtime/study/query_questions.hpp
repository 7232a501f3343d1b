#pragma once

#include <string>
#include <vector>

#include "orbweaver/contracts/surface_ways.hpp"
#include "study/query_reference.hpp"

namespace orbweaver::study {

/// Questions of one kind, with what may be answered.
struct QuestionSet {
    std::string name;     ///< "vertices"
    std::string meaning;  ///< in a few words
    std::vector<Stance> questions;
    std::vector<QueryTruth> truths;

    /// Whether ways of that kind answer such questions.
    bool suits(SurfaceWays::Finds finds) const;
};

/// `count` questions of each kind about a surface, the same for the same seed:
///   random      rays from outside at places in and around the surface: hits and misses
///   vertices    rays from outside at its vertices
///   edges       rays from outside at points on its edges
///   underfoot   bodies that walk over it, from the polygon where they last were
///   over_edges  bodies that have just walked over an edge beyond which the surface drops away
/// A kind for which the surface has no place is left out.
std::vector<QuestionSet> make_questions(const Surface& surface, std::uint64_t seed, std::size_t count);

}  // namespace orbweaver::study
