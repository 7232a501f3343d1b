#pragma once

#include <string>

#include "study/ways.hpp"

namespace orbweaver::study {

/// "questions,way,asked,missed,invented,error_m,median_error_m,cost_s", a line a row; with a column "setting"
/// after the way where there are settings.
std::string ways_csv(const WaysResult& result);
std::string ways_json(const WaysResult& result);
/// Error against cost, a plot for each kind of tasks.
std::string ways_svg(const WaysResult& result);
/// The plots, the sentences and the table.
std::string ways_page(const WaysResult& result);

}  // namespace orbweaver::study
