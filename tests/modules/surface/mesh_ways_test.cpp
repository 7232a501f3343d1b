#include "mesh_ways.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "obj_mesh.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;

TEST_CASE("each way answers by what it is named after", "[unit]") {
    const auto data = test::built(mesh::cube(2, 3));
    const MeshSurface cube(data.view(), std::nullopt, {});
    const MeshWays ways(cube);
    const Stance above{{0.3, 1.5, 0.2}, {0, 1, 0}, {1, 0, 0}};
    const Stance leaning{{0.3, 1.5, 0.2}, {-0.6, 0.8, 0}, {1, 0, 0}};
    const Stance senseless{{std::nan(""), 1, 0}, {0, 1, 0}, {1, 0, 0}};
    for (std::size_t i = 0; i < ways.ways().size(); ++i) {
        const SurfaceWays::Way& way = ways.ways()[i];
        CAPTURE(way.name);
        const std::vector<Stance> questions = {above, leaning, senseless};
        std::vector<SurfaceHit> hits(questions.size());
        ways.answer(i, questions, hits);
        CHECK(distance(cube.position(hits[0].at), {0.3, 1, 0.2}) < 1e-15);
        const bool is_nearest = way.finds == SurfaceWays::Finds::nearest;
        CHECK(distance(cube.position(hits[1].at), {is_nearest ? 0.3 : 0.675, 1, 0.2}) < 1e-15);
        CHECK(hits[2].answer == Answer::refused);
    }
}
