#include "shader.hpp"

#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::view {
namespace {

constexpr GLsizei kLogLength = 2048;

[[noreturn]] void fail(const char* what, const char* stage, const std::string& log) {
    throw Fault(FaultKind::internal, std::string("The ") + what + " shader does not " + stage +
                                         " with this graphics driver, which says: " + log);
}

/// A shader that goes when it has been linked, or when linking is given up.
class Stage {
public:
    Stage(const Gl& gl, GLenum type) : gl_(gl), name_(gl.CreateShader(type)) {}
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage() { gl_.DeleteShader(name_); }

    void compile(const char* what, const char* source) const {
        gl_.ShaderSource(name_, 1, &source, nullptr);
        gl_.CompileShader(name_);
        GLint good = 0;
        gl_.GetShaderiv(name_, GL_COMPILE_STATUS, &good);
        if (good != 0) return;
        std::string log(kLogLength, '\0');
        GLsizei length = 0;
        gl_.GetShaderInfoLog(name_, kLogLength, &length, log.data());
        fail(what, "compile", log.substr(0, static_cast<std::size_t>(length)));
    }
    GLuint name() const noexcept { return name_; }

private:
    const Gl& gl_;
    GLuint name_;
};

}  // namespace

Object make_program(const Gl& gl, const char* what, const char* vertex_source, const char* fragment_source) {
    const Stage vertex(gl, GL_VERTEX_SHADER);
    const Stage fragment(gl, GL_FRAGMENT_SHADER);
    vertex.compile(what, vertex_source);
    fragment.compile(what, fragment_source);
    Object program(gl, ObjectKind::program);
    gl.AttachShader(program.name(), vertex.name());
    gl.AttachShader(program.name(), fragment.name());
    gl.LinkProgram(program.name());
    GLint good = 0;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good != 0) return program;
    std::string log(kLogLength, '\0');
    GLsizei length = 0;
    gl.GetProgramInfoLog(program.name(), kLogLength, &length, log.data());
    fail(what, "link", log.substr(0, static_cast<std::size_t>(length)));
}

}  // namespace orbweaver::view
