#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "orbweaver/contracts/writing_ways.hpp"
#include "picture/picture.hpp"
#include "run/run_scene.hpp"

namespace orbweaver::study {

/// How what stands in a web is photographed.
struct Photograph {
    std::vector<WritingWays::Block> blocks;  ///< each a picture of its own
    double margin = 0;                       ///< m, around each block
    double blur = 0;                         ///< m, standard deviation of a Gaussian
    double pixel = 0;                        ///< m, a pixel's side
};

/// A block in shades of gray, silk dark, from the darkest to the brightest shade that there is.
struct BlockPictures {
    picture::GrayPicture plain;
    picture::GrayPicture blurred;  ///< with two pixels to the deviation of the blur
};

/// The view's own pictures of a scene's web at some times of a run, seen along its normal: of each time, and of
/// each block. Throws Fault as plan_scene() and sessions do; Fault(limit) where the picture would be larger
/// than a view may be; Fault(stopped) as soon as `stop_asked` says yes while the scene runs.
std::vector<std::vector<BlockPictures>> photograph(RunSettings run, const Photograph& how,
                                                   const std::vector<double>& times,
                                                   const std::function<bool()>& stop_asked = {});

}  // namespace orbweaver::study
