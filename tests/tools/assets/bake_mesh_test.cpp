#include "bake_mesh.hpp"

#include <catch2/catch.hpp>

#include "baked/content_hash.hpp"
#include "mesh_file.hpp"
#include "obj.hpp"
#include "orbweaver/fault.hpp"
#include "shapes.hpp"
#include "support/folder.hpp"
#include "verify.hpp"

using namespace orbweaver;

TEST_CASE("every shape is baked into a file that is sound and knows its source", "[unit]") {
    const test::Folder folder;
    for (const mesh::Shape& shape : mesh::shapes()) {
        INFO(shape.name);
        const std::string source = folder.write("m.obj", obj_text(shape.make(1, 3)));
        const mesh::Validation validation = bake_mesh(source, {}, {}, folder.path("m.baked"));
        const BakedFile file(folder.path("m.baked"), mesh::kMeshType, mesh::kMeshVersion);
        CHECK(file.source_hash() == hash_file(source));
        CHECK(mesh::validation_in(file) == validation);
        CHECK_NOTHROW(mesh::verify(mesh::mesh_in(file), validation, "m"));
    }
}

TEST_CASE("the same source gives the same file, byte by byte", "[unit]") {
    const test::Folder folder;
    const std::string source = folder.write("m.obj", obj_text(mesh::sphere(1, 6)));
    bake_mesh(source, {}, {}, folder.path("a"));
    bake_mesh(source, {}, {}, folder.path("b"));
    CHECK(test::read_file(folder.path("a")) == test::read_file(folder.path("b")));
}

TEST_CASE("a baked file is not baked again, and a refused source leaves no file", "[unit]") {
    const test::Folder folder;
    bake_mesh(folder.write("m.obj", obj_text(mesh::cube(1, 1))), {}, {}, folder.path("m.baked"));
    CHECK_THROWS_WITH(bake_mesh(folder.path("m.baked"), {}, {}, folder.path("n.baked")),
                      folder.path("m.baked") + ": is baked already; name what it was made from");
    CHECK_THROWS_AS(bake_mesh(folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), {}, {},
                              folder.path("n.baked")),
                    Fault);
    CHECK(folder.names() == std::vector<std::string>{"m.baked", "m.obj", "nan.obj"});
}
