#include "packing.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("packed vectors come back", "[unit]") {
    for (const std::size_t particles : {1, 2, 3, 4, 5, 8, 101}) {
        std::vector<Vec3> vectors;
        for (std::size_t i = 0; i < particles; ++i) {
            const auto n = static_cast<double>(i);
            vectors.push_back({n, n + 0.25, n + 0.5});
        }
        const Packing packing(particles);
        std::vector<double> packed(packing.length(), -1);
        packing.pack(vectors, packed);
        CHECK(packed[particles - 1] == vectors.back().x);
        CHECK(packed[packing.plane()] == vectors.front().y);
        CHECK(packed[2 * packing.plane()] == vectors.front().z);
        CHECK(packed[particles] == -1);  // padding is not touched
        std::vector<Vec3> back(particles);
        packing.unpack(packed, back);
        CHECK(back == vectors);
    }
}

TEST_CASE("particles may have places of their own", "[unit]") {
    const Packing packing(std::vector<std::uint32_t>{2, 0, 1});
    const std::vector<Vec3> vectors{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    std::vector<double> packed(packing.length());
    packing.pack(vectors, packed);
    CHECK(packed[0] == 4);
    CHECK(packed[2] == 1);
    CHECK(packed[packing.plane() + 1] == 8);
    std::vector<Vec3> back(3);
    packing.unpack(packed, back);
    CHECK(back == vectors);
}

TEST_CASE("a block may begin at the last particle", "[unit]") {
    for (std::size_t particles = 1; particles < 20; ++particles) {
        const Packing packing(particles);
        CHECK(packing.plane() % Packing::kLanes == 0);
        CHECK(packing.plane() >= particles - 1 + Packing::kLanes);
        CHECK(packing.plane() == Packing::kLanes * packing.blocks());
        CHECK(packing.length() == 3 * packing.plane());
    }
}
