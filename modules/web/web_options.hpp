#pragma once

#include <optional>

#include "construction.hpp"
#include "orbweaver/options.hpp"
#include "orbweaver/random.hpp"
#include "prestress.hpp"
#include "strand.hpp"
#include "web.hpp"

namespace orbweaver::web {

Construction read_construction(const Options& options);
/// Of the material that the table or its silk names; else of tensions and axial stiffnesses.
Silks read_silks(const Options& options, Diagnostics& faults);

/// Builds what a [web] table asks for. Nothing where it asks for none or several of anchors (or species),
/// network and strand, or where the one has faults; each is reported where the scene says it.
std::optional<Web> build_web(const Options& options, const Vec3& gravity, const RandomStream& irregularity,
                             Diagnostics& faults);

}  // namespace orbweaver::web
