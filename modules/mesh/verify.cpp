#include "verify.hpp"

#include <algorithm>

#include "build.hpp"
#include "orbweaver/fault.hpp"

namespace orbweaver::mesh {

namespace {

class Verifier {
public:
    Verifier(const SurfaceMesh& mesh, const std::string& name) : mesh_(mesh), name_(name) {}

    void check_triangles() const {
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const Triangle& corners = mesh_.triangles[t];
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
                refuse("triangle " + std::to_string(t) + " has one corner twice");
        }
        if (!std::is_sorted(mesh_.polygon.begin(), mesh_.polygon.end())) refuse("its polygons do not ascend");
    }

    template <class T>
    void check_same(const char* what, std::span<const T> found, const std::vector<T>& expected) const {
        const auto [here, there] = std::mismatch(found.begin(), found.end(), expected.begin(), expected.end());
        if (here != found.end() || there != expected.end())
            refuse(std::string(what) + " is wrong from record " + std::to_string(here - found.begin()) + " on");
    }

    [[noreturn]] void refuse(const std::string& what) const {
        throw Fault(FaultKind::invalid,
                    name_ + ": is unsound: " + what + "; bake it again with orbweaver-assets");
    }

private:
    const SurfaceMesh& mesh_;
    const std::string& name_;
};

}  // namespace

void verify(const SurfaceMesh& mesh, const Validation& validation, const std::string& name) {
    const Verifier verifier(mesh, name);
    verifier.check_triangles();
    SurfaceMeshData anew;
    anew.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
    anew.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    Validation counted = validation;
    join(anew, counted);
    verifier.check_same("across", mesh.across, anew.across);
    verifier.check_same("ring_first", mesh.ring_first, anew.ring_first);
    verifier.check_same("ring", mesh.ring, anew.ring);
    verifier.check_same("fan_first", mesh.fan_first, anew.fan_first);
    verifier.check_same("fan", mesh.fan, anew.fan);
    verifier.check_same("shell", mesh.shell, anew.shell);
    if (mesh.bounds != anew.bounds) verifier.refuse("its bounds are not those of its vertices");
    if (validation != counted) verifier.refuse("what it says of itself is not what counting gives");
}

}  // namespace orbweaver::mesh
