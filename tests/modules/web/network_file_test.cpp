#include "network_file.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

std::string network(const std::string& particles, const std::string& masses, const std::string& fixed,
                    const std::string& springs) {
    return R"({"particles": )" + particles + R"(, "masses": )" + masses + R"(, "fixed": )" + fixed +
           R"(, "springs": )" + springs + "}";
}

const std::string kThree = "[[0,0,0],[1,0,0],[2,0,0]]";
const std::string kForm = "; expected one object with the keys particles, masses, fixed and springs";

}  // namespace

TEST_CASE("a network file is read as written", "[unit]") {
    Diagnostics faults;
    const auto web = parse_network(network(kThree, "[1, 2, 3]", "[0, 2]", "[[0,1,0.5,10,0.1],[2,1,0.25,20,0]]"),
                                   "net.json", faults);
    REQUIRE(web);
    CHECK(faults.empty());
    CHECK(web->layout.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    CHECK(web->network.mass == std::vector<double>{1, 2, 3});
    CHECK(web->network.fixed == std::vector<std::uint8_t>{1, 0, 1});
    REQUIRE(web->network.springs.size() == 2);
    CHECK(web->network.springs[1].a == 2);
    CHECK(web->network.springs[1].rest_length == 0.25);
    CHECK(web->network.springs[0].damping == 0.1);
    CHECK(web->layout.center == Vec3{1, 0, 0});
}

TEST_CASE("one mass may stand for all", "[unit]") {
    Diagnostics faults;
    const auto web =
        parse_network(network(kThree, "0.5", "[]", "[[0,1,1,1,0],[1,2,1,1,0]]"), "net.json", faults);
    REQUIRE(web);
    CHECK(web->network.mass == std::vector<double>(3, 0.5));
}

TEST_CASE("a network file's faults are named with file and element", "[unit]") {
    struct Case {
        const char* name;
        std::string text;
        std::string expected;
    };
    const std::string chain = "[[0,1,1,1,0],[1,2,1,1,0]]";
    const std::vector<Case> cases = {
        {"empty file", "", "net.json: line 1, column 1 is not JSON" + kForm},
        {"not JSON", "{\n  \"particles\": oops\n}", "net.json: line 2, column 16 is not JSON" + kForm},
        {"cut off", R"({"particles": [[0,0)", "net.json: line 1, column 20 is not JSON" + kForm},
        {"not an object", "[1, 2]", "net.json: the file holds an array of 2" + kForm},
        {"too deep", "[[[[[]]]]]", "net.json: arrays are nested more than 3 deep" + kForm},
        {"overflow", network("[[1e999,0,0]]", "1", "[]", "[]"),
         "net.json: a number is too large for a double; expected finite numbers"},
        {"unknown key", R"({"particles": [[0,0,0]], "masses": 1, "fixed": [], "springs": [], "colour": 1})",
         "net.json: there is no key 'colour'" + kForm},
        {"missing key", R"({"particles": [[0,0,0]], "masses": 1, "fixed": []})",
         "net.json: springs is missing" + kForm},
        {"no particles", network("[]", "1", "[]", "[]"),
         "net.json: particles is empty; expected at least one [x, y, z]"},
        {"two coordinates", network("[[0,0]]", "1", "[]", "[]"),
         "net.json: particles[0] is an array of 2; expected [x, y, z] in m"},
        {"text coordinate", network("[[0,0,\"1\"]]", "1", "[]", "[]"),
         "net.json: particles[0] is an array of 3; expected [x, y, z] in m"},
        {"wrong size", network(kThree, "[1, 2]", "[]", chain),
         "net.json: masses has 2 elements for 3 particles; expected one mass in kg each, or one number for "
         "all"},
        {"text mass", network(kThree, "[1, \"2\", 3]", "[]", chain),
         "net.json: masses[1] is \"2\"; expected a mass in kg"},
        {"fixed out of range", network(kThree, "1", "[3]", chain),
         "net.json: fixed[0] names particle 3; expected an index from 0 to 2"},
        {"index out of range", network(kThree, "1", "[]", "[[0,1,1,1,0],[1,3,1,1,0]]"),
         "net.json: springs[1] names particle 3; expected an index from 0 to 2"},
        {"negative index", network(kThree, "1", "[]", "[[-1,1,1,1,0]]"),
         "net.json: springs[0] names particle -1; expected an index from 0 to 2"},
        {"fractional index", network(kThree, "1", "[]", "[[0.5,1,1,1,0]]"),
         "net.json: springs[0] names particle 0.5; expected an index from 0 to 2"},
        {"short spring", network(kThree, "1", "[]", "[[0,1,1]]"),
         "net.json: springs[0] is an array of 3; expected [i, j, rest_length, stiffness, damping]"},
        {"negative mass", network(kThree, "[1, -2, 1]", "[]", chain),
         "net.json: particles[1]: particle 1 has a mass of -2 kg; expected a finite mass above 0"},
        {"zero-length spring", network("[[0,0,0],[0,0,0]]", "1", "[]", "[[0,1,1,1,0]]"),
         "net.json: springs[0]: spring 0 has no length: particles 0 and 1 are at the same point, so its "
         "direction is undefined; move one of them"},
        {"spring to itself", network(kThree, "1", "[]", "[[1,1,1,1,0]]"),
         "net.json: springs[0]: spring 0 joins particle 1 to itself; expected two different particles"},
        {"two loose parts", network(kThree, "1", "[]", "[[0,1,1,1,0]]"),
         "net.json: the network is in 2 parts that no spring joins; expected one connected network; join them, "
         "or give each a file and a [[web]] of its own"},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        Diagnostics faults;
        CHECK_FALSE(parse_network(c.text, "net.json", faults));
        REQUIRE_FALSE(faults.empty());
        CHECK(to_string(faults.front()) == c.expected);
    }
}

TEST_CASE("a network of nothing but faults reports the first ten", "[extreme]") {
    std::string springs = "[[9,9,1,1,0]";
    for (int i = 0; i < 5000; ++i) springs += ",[9,9,1,1,0]";
    Diagnostics faults;
    CHECK_FALSE(parse_network(network(kThree, "1", "[]", springs + "]"), "net.json", faults));
    REQUIRE(faults.size() == 11);
    CHECK(faults.back().what == "and 9992 faults more");
}

TEST_CASE("ten megabytes of brackets are refused at the fourth", "[extreme]") {
    Diagnostics faults;
    CHECK_FALSE(parse_network(std::string(10u << 20, '['), "net.json", faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].what == "arrays are nested more than 3 deep");
}

TEST_CASE("a file that is not there is a fault", "[unit]") {
    Diagnostics faults;
    CHECK_FALSE(read_network("no/such/file.json", faults));
    CHECK(to_string(faults.front()) ==
          "no/such/file.json: this file cannot be read; expected a network in JSON");
}
