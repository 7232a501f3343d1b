#include "shader.hpp"

#include "offscreen.hpp"
#include "orbweaver/fault.hpp"

using namespace orbweaver;

namespace {

constexpr const char* kGood = "#version 330 core\nvoid main() { gl_Position = vec4(0); }";
constexpr const char* kUnlinked = "#version 330 core\nvec4 nobody(); out vec4 c; void main() { c = nobody(); }";

std::string sentence(const view::Gl& gl, const char* vertex, const char* fragment) {
    try {
        view::make_program(gl, "test", vertex, fragment);
    } catch (const Fault& e) {
        CHECK(e.kind() == FaultKind::internal);
        return e.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a shader that fails says which, in which stage, with the driver's words", "[extreme]") {
    const test::Offscreen canvas(16, 16);
    const auto broken = sentence(canvas.gl, "#version 330 core\nvoid main() { nonsense; }", kGood);
    CHECK(broken.find("The test shader does not compile with this graphics driver, which says: ") == 0);
    CHECK(broken.find("nonsense") != std::string::npos);
    CHECK(sentence(canvas.gl, kGood, kUnlinked).find("The test shader does not link") == 0);
}
