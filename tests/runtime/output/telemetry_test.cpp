#include "output/telemetry.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

TEST_CASE("telemetry has a row a frame, every column of every module, and the hash", "[unit]") {
    const Folder folder;
    const OpenedScene opened("[scene]\nstep = 0.1\n[[counter]]\n[[counter]]\n", {"counter"});
    Telemetry telemetry(*opened.session, folder.path("t.csv"));
    std::vector<std::vector<std::string>> expected{
        {"frame", "time_s", "counter.x", "counter.2.x", "state_hash"}};
    for (int i = 0; i < 4; ++i) {
        if (i > 0) opened.run(1);
        telemetry.record();
        std::vector<std::string> row{std::to_string(i)};
        for (const double value : {i * 0.1, opened.session->instances()[0]->telemetry_columns()[0].value(),
                                   opened.session->instances()[1]->telemetry_columns()[0].value()}) {
            char text[32];
            std::snprintf(text, sizeof text, "%.17g", value);
            row.emplace_back(text);
        }
        char hash[32];
        std::snprintf(hash, sizeof hash, "%016lx", static_cast<unsigned long>(opened.session->state_hash()));
        row.emplace_back(hash);
        expected.push_back(row);
    }
    CHECK_FALSE(std::filesystem::exists(folder.path("t.csv")));
    telemetry.commit();

    std::stringstream text(read_file(folder.path("t.csv")));
    std::size_t row = 0;
    for (std::string line; std::getline(text, line); ++row) {
        REQUIRE(row < expected.size());
        std::stringstream cells(line);
        std::size_t column = 0;
        for (std::string cell; std::getline(cells, cell, ','); ++column) {
            CAPTURE(row, column);
            REQUIRE(column < 5);
            const bool figure = row > 0 && column > 0 && column < 4;
            if (figure)
                CHECK(std::stod(cell) == std::stod(expected[row][column]));  // the very bits come back
            else
                CHECK(cell == expected[row][column]);
        }
        CHECK(column == 5);
    }
    CHECK(row == 5);
}

TEST_CASE("telemetry of a scene without modules is the clock and the hash", "[unit]") {
    const Folder folder;
    const OpenedScene opened("", {});
    Telemetry telemetry(*opened.session, folder.path("t.csv"));
    telemetry.commit();
    CHECK(read_file(folder.path("t.csv")) == "frame,time_s,state_hash\n");
}
