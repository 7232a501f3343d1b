#pragma once

#include <span>
#include <string_view>

#include "orbweaver/contracts/inscriber.hpp"
#include "orbweaver/random.hpp"
#include "page.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

/// What a scene chose of how it is to be written.
struct ModeSettings {
    int score_threshold = 8;  ///< segments that match better are taken, or kept, as the mode has it
    double width = 3;         ///< times as much silk as there was: the most that a thread is thickened to
    double attachments = 1;   ///< random_attachments: threads added, for each one taken
    double outline = 1;       ///< outline: width of the ring around letters, in meshes
    double loss = 0.3;        ///< legible: silk that may be added, over the silk of the plain web
};

/// What there is to write with.
struct Writing {
    const WebAtRest& web;
    const Page& page;
    const Bitmap& coverage;  ///< of the page: 1 is to be written
    const Bitmap& dilated;   ///< coverage, dilated by kDilation
    double mesh = 0;         ///< m, between neighboring turns of the spiral
    double blur = 0;         ///< m, through which it is to be read
    const ModeSettings& settings;
    RandomStream random;
};

/// A way of writing in webs: a pure function.
struct Mode {
    std::string_view name;
    std::string_view meaning;
    WebChange (*write)(const Writing&);
};

/// All of them; a new one is a file of its own and a line in modes.cpp.
std::span<const Mode> modes() noexcept;
/// Null where there is none of that name.
const Mode* find_mode(std::string_view name) noexcept;

WebChange remove_matches(const Writing& writing);      ///< see removal.cpp
WebChange crosshatch(const Writing& writing);          ///< see crosshatch.cpp
WebChange attach_at_random(const Writing& writing);    ///< see random_attachments.cpp
WebChange strengthen_outline(const Writing& writing);  ///< see outline.cpp
WebChange write_legibly(const Writing& writing);       ///< see legible.cpp

}  // namespace orbweaver::inscription
