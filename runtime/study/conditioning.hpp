#pragma once

#include <functional>
#include <string>
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
    Rung rung = {};                   ///< by which both were run

    /// The first row at or behind which details are lost; 0 when they are not.
    std::size_t statistics_row() const noexcept { return whole ? 0 : horizon_rows - 1; }
};

/// What twins are run by: equal steps of a method of reference, at most `longest` (s) of the method, since
/// these part twins by nothing of their own. Where both methods have tolerances alone, one of a hundredth of
/// the displacement: far below it, and far above rounding.
Rung twin_rung(const Subject& subject, const std::function<double(const std::string&)>& longest);

/// Displacements of this length (m) in directions from the seed, for all particles that move when they are
/// displaced for a frame of the scene so overridden; the others are held in place.
std::vector<Vec3> free_offsets(const StudySettings& settings, const Subject& subject,
                               const std::vector<std::string>& overrides, double length,
                               const Deadline& deadline);

/// The horizon of a twin's deviation, row by row.
Conditioning judge(const Motion& motion, const Motion& twin);

/// "a displacement of 1e-10 m grows to ... within ...: errors are measured up to ..."
std::string sentence(const Conditioning& conditioning);

}  // namespace orbweaver::study
