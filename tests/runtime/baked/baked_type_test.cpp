#include "baked/baked_type.hpp"

#include <catch2/catch.hpp>

#include "baked/baked_writer.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

TEST_CASE("a baked file tells its type, and what is none tells nothing", "[unit]") {
    const test::Folder folder;
    for (const char* type : {"t", "mesh", "eightlet"}) {
        BakedWriter(type, 1, {}).write(folder.path("f"));
        CHECK(baked_type(folder.path("f")) == type);
    }
    CHECK(baked_type(folder.write("short", "ORBWBAKE and no more")).empty());
    CHECK(baked_type(folder.write("other", std::string(100, 'x'))).empty());
    CHECK(baked_type(folder.path("none")).empty());
    CHECK(baked_type(folder.path()).empty());
}
