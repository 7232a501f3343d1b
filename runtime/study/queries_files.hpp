#pragma once

#include <string>

#include "study/queries.hpp"

namespace orbweaver::study {

/// "questions,way,asked,missed,invented,error_m,median_error_m,cost_s", a line a row.
std::string queries_csv(const QueryResult& result);
std::string queries_json(const QueryResult& result);
/// Error against cost, a plot for each kind of questions.
std::string queries_svg(const QueryResult& result);
/// The plots, the sentences and the table.
std::string queries_page(const QueryResult& result);

}  // namespace orbweaver::study
