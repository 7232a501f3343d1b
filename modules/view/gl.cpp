#include "gl.hpp"

#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::view {

Gl load_gl(const Canvas& canvas) {
    Gl gl;
    std::string missing;
#define ORBWEAVER_GL_LOAD(type, name)                                 \
    gl.name = reinterpret_cast<type>(canvas.gl_function("gl" #name)); \
    if (gl.name == nullptr) missing += missing.empty() ? "gl" #name : ", gl" #name;
    ORBWEAVER_GL_FUNCTIONS(ORBWEAVER_GL_LOAD)
#undef ORBWEAVER_GL_LOAD
    if (!missing.empty())
        throw Fault(FaultKind::internal,
                    "The canvas lacks functions of OpenGL 3.3 that the view calls: " + missing +
                        "; update the graphics driver, or draw off-screen with --headless.");
    return gl;
}

Object::Object(const Gl& gl, ObjectKind kind) : gl_(&gl), kind_(kind) {
    switch (kind) {
        case ObjectKind::buffer:
            gl.GenBuffers(1, &name_);
            break;
        case ObjectKind::framebuffer:
            gl.GenFramebuffers(1, &name_);
            break;
        case ObjectKind::program:
            name_ = gl.CreateProgram();
            break;
        case ObjectKind::texture:
            gl.GenTextures(1, &name_);
            break;
        case ObjectKind::vertex_array:
            gl.GenVertexArrays(1, &name_);
            break;
    }
}

Object::~Object() {
    if (gl_ == nullptr) return;
    switch (kind_) {
        case ObjectKind::buffer:
            gl_->DeleteBuffers(1, &name_);
            break;
        case ObjectKind::framebuffer:
            gl_->DeleteFramebuffers(1, &name_);
            break;
        case ObjectKind::program:
            gl_->DeleteProgram(name_);
            break;
        case ObjectKind::texture:
            gl_->DeleteTextures(1, &name_);
            break;
        case ObjectKind::vertex_array:
            gl_->DeleteVertexArrays(1, &name_);
            break;
    }
}

}  // namespace orbweaver::view
