#pragma once

#include "gl.hpp"

namespace orbweaver::view {

/// A linked program. `what` names it in sentences ("sky"). Throws Fault(internal) with the compiler's words.
Object make_program(const Gl& gl, const char* what, const char* vertex_source, const char* fragment_source);

}  // namespace orbweaver::view
