#pragma once

#include "grips.hpp"
#include "orbweaver/module.hpp"

namespace orbweaver::surface {

/// What the options friction, climbable, material.* and patch.* say of a mesh. Everything wrong with them goes
/// to host.report_fault().
GripOverrides grips_of(const mesh::SurfaceMesh& mesh, Host& host);

}  // namespace orbweaver::surface
