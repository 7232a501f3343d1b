#include "output/trajectory.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/npy.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;
using nlohmann::json;

TEST_CASE("a trajectory holds every recorded quantity of every frame, and says what each means", "[unit]") {
    const Folder folder;
    const OpenedScene opened(
        "[scene]\nstep = 0.25\nname = \"walk\"\n[[counter]]\n[[counter]]\norigin = [1, 2, 3]\n", {"counter"});
    Trajectory trajectory(*opened.session, folder.path("t/u"));
    std::vector<Vec3> places;
    const auto record = [&] {
        trajectory.record();
        const auto* place =
            static_cast<const Vec3*>(opened.session->instances()[1]->block().entries()[1].memory());
        places.insert(places.end(), place, place + 2);
    };
    record();
    for (int i = 0; i < 4; ++i) {
        opened.run(1);
        record();
    }
    CHECK_FALSE(std::filesystem::exists(folder.path("t/u/trajectory.json")));
    trajectory.commit();

    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("t/u")))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    CHECK(names == std::vector<std::string>{"counter.2.count.npy", "counter.2.place.npy", "counter.count.npy",
                                            "counter.place.npy", "time.npy", "trajectory.json"});

    CHECK(Npy(folder.path("t/u/time.npy")).values<double>() == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
    CHECK(Npy(folder.path("t/u/counter.count.npy")).values<std::uint64_t>() ==
          std::vector<std::uint64_t>{0, 1, 2, 3, 4});
    const Npy place(folder.path("t/u/counter.2.place.npy"));
    CHECK(place.type == "<f8");
    CHECK(place.shape == std::vector<std::size_t>{5, 2, 3});
    const auto values = place.values<Vec3>();
    CHECK(values == places);
    CHECK(values[0] == Vec3{1, 2, 3});
    CHECK(values[2] != values[0]);

    const json said = json::parse(read_file(folder.path("t/u/trajectory.json")));
    CHECK(said["scene"] == "walk");
    CHECK(said["frame_step_s"] == 0.25);
    CHECK(said["quantities"].size() == 5);
    CHECK(said["quantities"]["counter.2.place"] ==
          json({{"file", "counter.2.place.npy"},
                {"shape", {5, 2, 3}},
                {"unit", "m"},
                {"meaning", "where the walk is, and where it began"}}));
    CHECK(said["quantities"]["counter.count"]["shape"] == json({5, 1}));
    CHECK(said["quantities"]["time"]["unit"] == "s");
    for (const auto& [name, quantity] : said["quantities"].items())
        CHECK(Npy(folder.path("t/u/" + quantity["file"].get<std::string>())).shape ==
              quantity["shape"].get<std::vector<std::size_t>>());
}

TEST_CASE("a trajectory that is given up leaves no file", "[extreme]") {
    const Folder folder;
    const OpenedScene opened("[counter]\n", {"counter"});
    { Trajectory(*opened.session, folder.path()).record(); }
    CHECK(folder.names().empty());
    folder.write("file", "x");
    CHECK(fault_of([&] { Trajectory(*opened.session, folder.path("file/t")); }) ==
          folder.path("file/t/time.npy") +
              ": cannot be written: Not a directory; check that the folder exists and may be written");
}

TEST_CASE("a scene's name that is no UTF-8 does not keep a trajectory from its end", "[extreme]") {
    const Folder folder;
    OpenedScene opened("[counter]\n", {"counter"});
    opened.plan.scene.name = "meadow\xff";
    const Session session(opened.plan, opened.request);
    Trajectory trajectory(session, folder.path("t"));
    trajectory.record();
    trajectory.commit();
    CHECK(json::parse(read_file(folder.path("t/trajectory.json")))["scene"] == "meadow\uFFFD");
}
