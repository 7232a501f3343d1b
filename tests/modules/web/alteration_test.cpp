#include "alteration.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "mass_spring/spring_system.hpp"
#include "orbweaver/fault.hpp"
#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

Web plain_web() {
    Web web{web::test::ideal_web(12, 6, 0.01), {}};
    web.network = find_form(web.layout, web::test::default_silks(), web::test::kMass, 1e-7, {});
    return web;
}

double total_mass(const Web& web) {
    return std::accumulate(web.network.mass.begin(), web.network.mass.end(), 0.0);
}

std::uint32_t first_of(const Web& web, Kind kind) {
    std::uint32_t i = 0;
    while (web.layout.pieces[i].kind != kind) ++i;
    return i;
}

double tension_of(const Web& web, std::size_t i) {
    return mass_spring::tension(web.network.springs[i], web.layout.positions);
}

std::string refusal(const Web& web, const WebChange& change) {
    try {
        alter(web, change);
    } catch (const Fault& fault) {
        return fault.what();
    }
    return "";
}

}  // namespace

TEST_CASE("threads that stay keep their order and their springs", "[unit]") {
    const Web plain = plain_web();
    const std::uint32_t spiral = first_of(plain, Kind::spiral);
    const Web changed = alter(plain, {{spiral}, {}, {}});
    REQUIRE(changed.network.springs.size() + 1 == plain.network.springs.size());
    for (std::size_t i = 0; i < changed.network.springs.size(); ++i) {
        const auto& before = plain.network.springs[i < spiral ? i : i + 1];
        CHECK(changed.network.springs[i].a == before.a);
        CHECK(changed.network.springs[i].rest_length == before.rest_length);
        CHECK(changed.layout.pieces[i].kind == plain.layout.pieces[i < spiral ? i : i + 1].kind);
    }
}

TEST_CASE("a thread cut into parts pulls as the whole did, and weighs as much", "[unit]") {
    const Web plain = plain_web();
    const std::uint32_t spiral = first_of(plain, Kind::spiral);
    const Web changed = alter(plain, {{}, {}, {{spiral, 0.2, 0.5, 1}, {spiral, 0.7, 1, 1}}});
    REQUIRE(changed.layout.pieces.size() == plain.layout.pieces.size() + 3);
    REQUIRE(changed.network.size() == plain.network.size() + 3);
    double compliance = 0;
    for (std::size_t i = spiral; i < spiral + 4; ++i) {
        CHECK(tension_of(changed, i) == Approx(tension_of(plain, spiral)).epsilon(1e-9));
        compliance += 1 / changed.network.springs[i].stiffness;  // springs in series
    }
    CHECK(1 / compliance == Approx(plain.network.springs[spiral].stiffness).epsilon(1e-12));
    CHECK(total_mass(changed) == Approx(total_mass(plain)).epsilon(1e-12));
    CHECK(changed.layout.pieces[spiral].a == plain.layout.pieces[spiral].a);
    CHECK(changed.layout.pieces[spiral + 3].b == plain.layout.pieces[spiral].b);
}

TEST_CASE("thicker thread is as taut, as many times as stiff, and weighs its silk more", "[unit]") {
    const Web plain = plain_web();
    const std::uint32_t spiral = first_of(plain, Kind::spiral);
    const Web changed = alter(plain, {{}, {}, {{spiral, 0, 1, 3}}});
    CHECK(tension_of(changed, spiral) == Approx(tension_of(plain, spiral)).epsilon(1e-9));
    const auto axial = [&](const Web& web) {
        const mass_spring::Spring& s = web.network.springs[spiral];
        return s.stiffness * s.rest_length;
    };
    CHECK(axial(changed) == Approx(3 * axial(plain)).epsilon(1e-12));
    CHECK(changed.layout.pieces[spiral].width == 3);
    const Piece& piece = plain.layout.pieces[spiral];
    double silk = 0;  // that both ends' weights are spread over
    for (const Piece& each : plain.layout.pieces)
        for (const Index end : {each.a, each.b})
            if (end == piece.a)
                silk += distance(plain.layout.positions[each.a], plain.layout.positions[each.b]) / 2;
    const double length = distance(plain.layout.positions[piece.a], plain.layout.positions[piece.b]);
    CHECK(changed.network.mass[piece.a] ==
          Approx(plain.network.mass[piece.a] * (1 + 2 * (length / 2) / silk)).epsilon(1e-9));
}

TEST_CASE("an added thread is of the sort of another, and as taut", "[unit]") {
    const Web plain = plain_web();
    const std::uint32_t like = first_of(plain, Kind::spiral);
    const Index a = plain.layout.spokes[0][2], b = plain.layout.spokes[1][4];
    const Web changed = alter(plain, {{}, {{a, b, like, 2}}, {}});
    const std::size_t last = changed.layout.pieces.size() - 1;
    CHECK(changed.layout.pieces[last].kind == Kind::spiral);
    CHECK(changed.layout.pieces[last].width == 2);
    CHECK(tension_of(changed, last) == Approx(tension_of(plain, like)).epsilon(1e-9));
    CHECK(total_mass(changed) > total_mass(plain));
}

TEST_CASE("changes that make no sense are refused in words", "[unit]") {
    const Web plain = plain_web();
    const auto many = static_cast<std::uint32_t>(plain.layout.pieces.size());
    const Index a = plain.layout.spokes[0][2];
    const double nan = std::nan("");
    CHECK(refusal(plain, {{many}, {}, {}}).find("there is no thread " + std::to_string(many)) !=
          std::string::npos);
    CHECK(refusal(plain, {{3, 3}, {}, {}}).find("thread 3 is taken twice") != std::string::npos);
    CHECK(refusal(plain, {{3}, {}, {{3, 0, 1, 2}}}).find("is not there") != std::string::npos);
    CHECK(refusal(plain, {{}, {}, {{3, 0, 0.5, 2}, {3, 0.4, 1, 2}}}).find("overlap") != std::string::npos);
    CHECK(refusal(plain, {{}, {}, {{3, 0.5, 0.5, 2}}}).find("from 0.5 to 0.5") != std::string::npos);
    CHECK(refusal(plain, {{}, {}, {{3, 0, 1, nan}}}).find("nan times as thick") != std::string::npos);
    CHECK(refusal(plain, {{}, {{a, a, 0, 1}}, {}}).find("no thread can lead") != std::string::npos);
    CHECK(refusal(plain, {{}, {{0, 1, many, 1}}, {}}).find("to be like") != std::string::npos);
    CHECK(refusal(plain, {{}, {{0, 1, 0, 0}}, {}}).find("cannot be 0 times as thick") != std::string::npos);
    std::vector<std::uint32_t> all(many);
    std::iota(all.begin(), all.end(), 0U);
    CHECK(refusal(plain, {all, {}, {}}).find("come off") != std::string::npos);
}
