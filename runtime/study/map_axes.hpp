#pragma once

#include <vector>

#include "study/axis.hpp"
#include "study/trial.hpp"

namespace orbweaver::study {

/// "web.step=0.001": the override that puts a value of an axis into a scene.
std::string assignment(const MapAxis& axis, double value);

/// The two options that a map varies.
struct MapAxes {
    MapAxis x, y;
    int step_axis = -1;  ///< 0: x is the step of the subject's methods; 1: y is; -1: neither

    std::size_t columns() const noexcept { return x.values.size(); }
    std::size_t cells() const noexcept { return x.values.size() * y.values.size(); }
    /// The values of a cell, which lies at row * columns() + column.
    double x_of(std::size_t cell) const { return x.values[cell % columns()]; }
    double y_of(std::size_t cell) const { return y.values[cell / columns()]; }
    /// The axis that is not the step.
    const MapAxis& other() const noexcept { return step_axis == 0 ? y : x; }
    /// What a cell changes of the scene itself; the step is none of it.
    std::vector<std::string> physics(std::size_t cell) const;
};

/// The axes asked for, completed by the step around what the scene bears and by the module's own axis. Steps
/// are moved to the nearest that divide a frame, since others are not taken as asked. Throws Fault(invalid) for
/// axes that the scene does not know or whose ends it refuses.
MapAxes choose_axes(const StudySettings& settings, const Subject& subject, const std::vector<AxisText>& asked,
                    const Deadline& deadline);

}  // namespace orbweaver::study
