#pragma once

#include <vector>

#include "study/axis.hpp"
#include "study/study_settings.hpp"

namespace orbweaver::study {

/// Studies a scene and leaves the files of the study in settings.out; prints what it comes to. A signal
/// ends it early, with what was found so far. Throws Fault.
void run_accuracy(const StudySettings& settings);
void run_stability(const StudySettings& settings, const std::vector<AxisText>& axes);
void run_queries(const StudySettings& settings);
/// Of a scene, or of a name: the scene assets/studies/ik.toml with that in place of what its module is called
/// by.
void run_reaches(const StudySettings& settings);
/// `orbweaver study inscription SCENE`: see study_writings().
void run_writings(const StudySettings& settings);

}  // namespace orbweaver::study
