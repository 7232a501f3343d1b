#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "scene/units.hpp"

namespace orbweaver::study {

/// "web.step=10 us..20 ms:16" as typed, with ":lin" or ":log" behind it or not.
struct AxisText {
    std::string path;
    Quantity low;
    Quantity high;
    int count = 0;
    std::optional<bool> log;
};

/// Nothing when it is not PATH=LOW..HIGH:COUNT[:lin|:log], with numbers that rise and a COUNT of 2 to 200.
std::optional<AxisText> parse_axis(const std::string& text);

/// An option of the scene that a map varies.
struct MapAxis {
    std::string path;    ///< "web.step"
    std::string table;   ///< "web"
    std::string option;  ///< "step"
    std::string unit;
    std::vector<double> values;  ///< in that unit, rising
    bool log = true;
    std::optional<double> own;  ///< the scene's own value; nothing when the scene leaves it open
};

/// `count` values from low to high, evenly spaced in the logarithm or not.
std::vector<double> spaced(double low, double high, int count, bool log);

/// Finds the option that an axis names in the plan. Logarithmic when both ends are positive unless it says
/// otherwise. Throws Fault(invalid): no such table in the scene, no such option, no number, another unit.
MapAxis resolve_axis(const AxisText& text, const Plan& plan);

}  // namespace orbweaver::study
