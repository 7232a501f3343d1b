#include "obj.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver;

TEST_CASE("OBJ counts from one, names materials where they change, and keeps every digit", "[unit]") {
    mesh::RawMesh raw;
    raw.points = {{0.1, -2, 3e-9}, {1.0 / 3, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    raw.material_names = {"bark", "glass"};
    raw.add_polygon({0, 1, 2}, 1);
    raw.add_polygon({0, 1, 2, 3}, 1);
    raw.add_polygon({3, 2, 1}, 0);
    CHECK(obj_text(raw) ==
          "v 0.1 -2 3e-09\nv 0.3333333333333333 0 0\nv 0 1 0\nv 0 0 1\n"
          "usemtl glass\nf 1 2 3\nf 1 2 3 4\nusemtl bark\nf 4 3 2\n");
}
