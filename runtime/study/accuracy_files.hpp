#pragma once

#include <string>
#include <vector>

#include "study/accuracy.hpp"

namespace orbweaver::study {

/// "method,step_s,tolerance,error_m,wall_s,steps,outcome"; what a row does not have is left empty.
std::string accuracy_csv(const AccuracyResult& result);
/// "method,step_s,tolerance,mean_energy_relative,mean_shape_m,spectrum_distance,frequency_relative,
/// power_relative": how far each run's statistics lie from the reference's, after those of the twin.
std::string statistics_csv(const AccuracyResult& result);
std::string accuracy_json(const AccuracyResult& result);
/// Error against run time, both logarithmic, a line a method.
std::string accuracy_svg(const AccuracyResult& result);
std::string accuracy_page(const AccuracyResult& result);
/// What is printed: conditioning, reference, and a sentence a decade.
std::vector<std::string> accuracy_sentences(const AccuracyResult& result);

}  // namespace orbweaver::study
