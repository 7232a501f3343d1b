#pragma once

#include <span>
#include <vector>

#include "box.hpp"
#include "orbweaver/contracts/threads.hpp"
#include "page.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

/// How well what a web shows agrees with what was to be written, from 0 to 1 unless said otherwise.
struct Legibility {
    double iou = 0;       ///< intersection over union of what is dark in the target and in the picture
    double ssim = 0;      ///< structural similarity (Wang et al. 2004) of both, -1 to 1
    double contrast = 1;  ///< silk per area inside of the target over that beside it; 1: none
};

/// What was to be written, as a page shows it.
struct Lettering {
    Page page;
    Bitmap coverage;
    std::vector<Box> blocks;  ///< of what is dark, one or two
    double blur = 0;          ///< m, standard deviation of the Gaussian through which a distant viewer sees
    double cut = 0;           ///< pixels that are dark in the target and lie beside the page

    /// Of all that is dark in the target.
    double cut_share() const;
};

/// Measures within the blocks, grown by the blur to each side.
///
/// The picture is the web's ink, blurred; where its contrast is below 1, its negative. For `iou` it is parted
/// in two by Otsu's threshold, block by block, and what is cut counts as dark in the target alone. For `ssim`
/// the picture and the coverage, blurred as well, are each stretched from 0 to 1 in a block; windows are
/// Gaussians of the blur's width, with the usual constants 0.01^2 and 0.03^2.
Legibility measure_legibility(std::span<const Vec3> points, std::span<const ThreadSegment> segments,
                              const Lettering& lettering);

}  // namespace orbweaver::inscription
