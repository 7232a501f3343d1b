#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "study/axis_text.hpp"

namespace orbweaver::study {

/// An option of the scene that a map varies.
struct MapAxis {
    std::string path;    ///< "web.step"
    std::string table;   ///< "web"
    std::string option;  ///< "step"
    std::string unit;
    std::vector<double> values;       ///< in that unit, rising; where there are labels: 0, 1, 2, ...
    std::vector<std::string> labels;  ///< the values of an option that is no number, as typed
    bool log = true;
    std::optional<double> own;  ///< the scene's own value among these; nothing when the scene leaves it open
    bool physical = true;       ///< it changes what is simulated, and not how

    bool labelled() const noexcept { return !labels.empty(); }
    /// A value as an override writes it.
    std::string text(std::size_t i) const;
    /// "web.step=0.001": the override that puts a value into a scene.
    std::string assignment(std::size_t i) const { return path + "=" + text(i); }
};

/// `count` values from low to high, evenly spaced in the logarithm or not.
std::vector<double> spaced(double low, double high, int count, bool log);

/// The value that a plan gives to the option of an axis; nothing when the scene leaves it open.
std::optional<OptionValue> planned_value(const MapAxis& axis, const Plan& plan);

/// Finds the option that an axis names in the plan. Options of whole numbers take the whole numbers nearest to
/// a range. Logarithmic when all values are positive, unless it says otherwise. Of labelled axes `own` is not
/// yet known. Throws Fault(invalid): no such table in the scene, no such option, no number where one is to be,
/// another unit, a value twice.
MapAxis resolve_axis(const AxisText& text, const Plan& plan);

}  // namespace orbweaver::study
