#pragma once

#include <vector>

#include "study/axis.hpp"
#include "study/trial.hpp"

namespace orbweaver::study {

/// The two options that a map varies.
struct MapAxes {
    MapAxis x, y;
    int step_axis = -1;  ///< 0: x is the step of the subject's methods; 1: y is; -1: neither

    std::size_t columns() const noexcept { return x.values.size(); }
    std::size_t cells() const noexcept { return x.values.size() * y.values.size(); }
    /// Where on each axis a cell stands; it lies at row * columns() + column.
    std::size_t column(std::size_t cell) const noexcept { return cell % columns(); }
    std::size_t row(std::size_t cell) const noexcept { return cell / columns(); }
    /// The axis that is not the step.
    const MapAxis& other() const noexcept { return step_axis == 0 ? y : x; }
    /// s, the step of a cell; 0 when neither axis is the step.
    double step_of(std::size_t cell) const;
    /// What a cell changes of the scene itself, and not of how it is integrated.
    std::vector<std::string> physics(std::size_t cell) const;
};

/// s, the step that the scene asks for; its frame when it names none.
double asked_step(const Subject& subject, const Plan& plan);

/// The axes asked for, completed by the step around what the scene bears and what it asks for, and by the
/// module's own axis. Steps are moved to the nearest that divide a frame, since others are not taken as asked.
/// Throws Fault(invalid) for axes that the scene does not know, whose values it refuses, or that have no effect
/// in a study.
MapAxes choose_axes(const StudySettings& settings, const Subject& subject, const std::vector<AxisText>& asked,
                    const Deadline& deadline);

}  // namespace orbweaver::study
