#pragma once

#include <cstdint>

#include "picture/picture.hpp"

namespace orbweaver {

struct SkyRecipe {
    int width = 2048;  ///< pixels; height is usually half of it
    int height = 1024;
    std::uint64_t seed = 1;
};

/// A summer meadow under a morning sky, out of focus as behind a macro photograph's subject: an equirectangular
/// picture whose middle is -z. A pure function of its recipe. Deep greens fill the middle, so that pale
/// threads stand out; the sun stands low, left of it. Throws Fault(invalid) for sizes outside 16 to 16384.
picture::Picture make_sky(const SkyRecipe& recipe);

}  // namespace orbweaver
