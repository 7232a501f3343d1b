#pragma once

#include <vector>

#include "study/trial.hpp"

namespace orbweaver::study {

inline constexpr double kDisplacement = 1e-10;  ///< m, of the twin's free particles
inline constexpr double kUseless = 1e-6;        ///< m, where the twin's distance says that details are lost

/// How fast two runs part that begin 1e-10 m apart: what no method can undo.
struct Conditioning {
    std::vector<double> time_s;       ///< s, of each row
    std::vector<double> deviation_m;  ///< m, largest distance of a particle from its twin
    double horizon_s = 0;             ///< s, until which it stays below 1e-6 m
    std::size_t horizon_rows = 0;     ///< as many rows lie before it; at least 2
    bool whole = false;               ///< the horizon is the run's end
};

/// Displacements of this length (m) in directions from the seed, for all particles that move when they are
/// displaced for a frame; the others are held in place.
std::vector<Vec3> free_offsets(const StudySettings& settings, const Subject& subject, const Rung& rung,
                               double length, const Deadline& deadline);

/// The horizon of a twin's deviation, row by row.
Conditioning judge(const Motion& motion, const Motion& twin);

/// "a displacement of 1e-10 m grows to ... within ...: errors are measured up to ..."
std::string sentence(const Conditioning& conditioning);

}  // namespace orbweaver::study
