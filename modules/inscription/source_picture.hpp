#pragma once

#include <span>

#include "mode.hpp"

namespace orbweaver::inscription {

/// The dilated picture of a web that the thesis captures from the screen: every thread of it a line one pixel
/// wide, and so the threads of a change that are added.
Bitmap source_picture(const WebAtRest& web, const Page& page, std::span<const WebChange::Added> added = {});

}  // namespace orbweaver::inscription
