#include "imported_mesh_bytes.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "shapes.hpp"

using namespace orbweaver;

namespace {

ImportedMesh sample() {
    ImportedMesh sample{mesh::branch(1, 1), {"a.mtl", "", "b.bin"}};
    sample.raw.material_names = {"bark", ""};
    return sample;
}

}  // namespace

TEST_CASE("a mesh comes through bytes as it was", "[unit]") {
    const ImportedMesh before = sample();
    const ImportedMesh after = imported_mesh_from_bytes(to_bytes(before), "m");
    CHECK(after.raw.points == before.raw.points);
    CHECK(after.raw.corners == before.raw.corners);
    CHECK(after.raw.first == before.raw.first);
    CHECK(after.raw.material == before.raw.material);
    CHECK(after.raw.material_names == before.raw.material_names);
    CHECK(after.companions == before.companions);
}

TEST_CASE("bytes that are cut short anywhere, or go on, are refused", "[unit]") {
    const std::string bytes = to_bytes(sample());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        REQUIRE_THROWS_AS(imported_mesh_from_bytes(bytes.substr(0, length), "m"), Fault);
    CHECK_THROWS_WITH(imported_mesh_from_bytes(bytes + "x", "m"),
                      "m: the importer's answer is cut short; export the mesh again");
    std::string huge = bytes;
    huge.replace(0, 8, std::string("\xff\xff\xff\xff\xff\xff\xff\x1f", 8));
    CHECK_THROWS_AS(imported_mesh_from_bytes(huge, "m"), Fault);
}
