#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lattice.hpp"
#include "orbweaver/contracts/creatures.hpp"
#include "orbweaver/contracts/patches.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "run/snapshot.hpp"
#include "sanitized.hpp"
#include "scene/toml_reader.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;
using crawler::Lattice;

namespace {

/// A scene given as text, opened as the program does.
struct Opened {
    Catalog catalog = read_catalog({ORBWEAVER_MODULE_DIR});
    Plan plan;
    std::unique_ptr<Session> session;

    explicit Opened(const std::string& text, const Request& request = {}) {
        plan = make_plan(read_toml_text(text, "scene.toml"), "scene.toml", catalog, {});
        for (const Diagnostic& fault : plan.faults) FAIL(to_string(fault));
        session = std::make_unique<Session>(plan, request);
        for (const Diagnostic& fault : session->faults()) FAIL(to_string(fault));
    }
    void run(double seconds) const {
        for (int i = 0; i < std::lround(seconds * 60); ++i) session->step();
    }
    Instance& instance(std::size_t number = 0) const {
        std::size_t found = 0;
        for (const auto& each : session->instances())
            if (each->manifest().id == "crawler" && found++ == number) return *each;
        FAIL("there is no such crawler");
        return *session->instances().front();
    }
    std::span<const Vec3> points(std::size_t number = 0) const {
        for (const StateBlock::Entry& entry : instance(number).block().entries())
            if (entry.name == "position")
                return {static_cast<const Vec3*>(entry.memory()), entry.bytes() / sizeof(Vec3)};
        FAIL("there are no positions");
        return {};
    }
    const Creatures& creatures(std::size_t table = 0) const { return *session->collect<Creatures>().at(table); }
    Vec3 center(std::size_t body = 0) const { return creatures().positions()[body]; }
    /// Of one body: from its tail to its head, degrees from +x towards -z, which is to the left.
    double heading() const {
        const auto all = points();
        const Vec3 way = crawler::ring_middle(&all[all.size() - 4]) - crawler::ring_middle(all.data());
        return std::atan2(-way.z, way.x) * 180 / std::acos(-1.0);
    }
    double lowest() const {
        const auto all = points();
        return std::min_element(all.begin(), all.end(), [](const Vec3& a, const Vec3& b) { return a.y < b.y; })
            ->y;
    }
    double measure(const std::string& name, std::size_t number = 0) const {
        for (const auto& [key, value] : instance(number).report().measures)
            if (key == name) {
                if (const auto* count = std::get_if<std::int64_t>(&value)) return static_cast<double>(*count);
                return std::get<double>(value);
            }
        FAIL("there is no measure " + name);
        return 0;
    }
};

/// A worm whose period is half of that of its kind, and a snake of few segments that are soft: both are quick
/// to run.
const std::string kWorm = "[[crawler]]\nkind = \"worm\"\nperiod = \"1 s\"\n";
const std::string kSnake =
    "[[crawler]]\nkind = \"snake\"\nsegments = 16\ntime_unit = \"2 ms\"\nperiod = \"1 s\"\n";

}  // namespace

TEST_CASE("a worm gets on ahead, and its friction takes what its muscles give", "[unit]") {
    const Opened worm(kWorm);
    worm.run(4);
    CHECK(worm.center().x > 0.02);
    CHECK(std::abs(worm.center().z) < 1e-4);
    CHECK(worm.measure("mean_speed_m_s") == Approx(worm.center().x / 4).epsilon(0.3));
    CHECK(worm.measure("work_in_j") > 0);
    CHECK(worm.measure("friction_loss_j") > 0.5 * worm.measure("work_in_j"));
    CHECK(worm.measure("unexplained_share") < 0.02);
}

TEST_CASE("by every method a worm crawls alike at the step that it takes unless told another", "[unit]") {
    if (kSanitized) return;
    const Opened usual(kWorm);
    usual.run(3);
    for (const char* method :
         {"explicit_euler", "verlet", "rk4", "tsit5", "rkc2", "implicit_euler", "tr_bdf2", "provot", "xpbd"}) {
        CAPTURE(method);
        const Opened worm(kWorm + "method = \"" + method + "\"\n");
        worm.run(3);
        CHECK(worm.measure("lengths_per_cycle") ==
              Approx(usual.measure("lengths_per_cycle")).epsilon(std::string(method) == "xpbd" ? 0.05 : 0.01));
        // What xpbd leaves undone of each spring is what its books lack.
        CHECK(worm.measure("unexplained_share") < (std::string(method) == "xpbd" ? 0.2 : 0.03));
    }
}

TEST_CASE("in the middle of a fall books close too", "[unit]") {
    for (const char* method : {"symplectic_euler", "explicit_euler", "rk4", "implicit_euler"}) {
        CAPTURE(method);
        const Opened worm("[[crawler]]\nkind = \"worm\"\nheight = \"1 m\"\nmethod = \"" + std::string(method) +
                          "\"\n");
        worm.run(0.3);
        CHECK(worm.center().y < 0.6);
        const double fallen = worm.measure("body_mass_kg") * 9.81 * (1.003 - worm.center().y);
        CHECK(std::abs(worm.measure("unexplained_energy_j")) < 1e-9 * fallen);
    }
}

TEST_CASE("what nothing damps loses nothing to damping", "[unit]") {
    const Opened worm(kWorm + "damping = 0\nheight = \"2 cm\"\n");
    worm.run(0.3);
    CHECK(worm.measure("impact_loss_j") > 0);
    CHECK(worm.measure("damping_loss_j") == 0);
}

TEST_CASE("who seeks a point to the left turns left, and to the right right", "[unit]") {
    for (const std::string& kind : {kWorm, kSnake}) {
        CAPTURE(kind);
        const Opened left(kind + "seek.point = [0.3, 0, -1]\n"), right(kind + "seek.point = [0.3, 0, 1]\n");
        left.run(kSanitized ? 2 : 6);
        right.run(kSanitized ? 2 : 6);
        const double least = kSanitized ? 0.5 : 5;
        CHECK(left.heading() > least);
        CHECK(right.heading() < -least);
    }
}

TEST_CASE("a snake comes to the point that it seeks", "[unit]") {
    if (kSanitized) return;
    const Vec3 goal{0.5, 0, -0.5};
    const Opened snake(kSnake + "seek.point = [0.5, 0, -0.5]\n");
    double nearest = 1e9;
    for (int i = 0; i < 60 && nearest > 0.1; ++i) {
        snake.run(0.25);
        nearest = std::min(nearest, distance(snake.center(), goal));
    }
    CHECK(nearest <= 0.1);
}

TEST_CASE("a loop is followed all the way round", "[unit]") {
    if (kSanitized) return;
    const double radius = 0.35;
    std::string path = "[crawler.follow_path]\nloop = true\npoints = [";
    for (int i = 0; i < 12; ++i) {
        const double angle = i * std::acos(-1.0) / 6;
        path += "[" + std::to_string(radius * std::sin(angle)) + ", 0, " +
                std::to_string(radius - radius * std::cos(angle)) + "], ";
    }
    const Opened snake(kSnake + path + "]\n");
    double turned = 0, far = 0, before = 0;
    for (int i = 0; i < 400 && turned < 2 * std::acos(-1.0); ++i) {
        snake.run(0.1);
        const Vec3 off = snake.center() - Vec3{0, 0, radius};
        const double angle = std::atan2(off.x, -off.z);
        turned += std::remainder(angle - before, 2 * std::acos(-1.0));
        before = angle;
        far = std::max(far, std::abs(std::hypot(off.x, off.z) - radius));
    }
    CHECK(turned >= 2 * std::acos(-1.0));
    CHECK(far < 0.15);
}

TEST_CASE("a pace of 0 stands still, and one of -1 goes back where 1 came from", "[unit]") {
    const std::string even = "friction = { forward = 0.1, backward = 0.1, sideways = 0.3 }\n";
    const Opened ahead(kWorm), still(kWorm + "control = [{ pace = 0 }]\n");
    ahead.run(3);
    still.run(3);
    CHECK(ahead.center().x > 0.01);
    CHECK(std::abs(still.center().x) < 0.1 * ahead.center().x);
    const double before = still.center().x;
    still.run(1);
    CHECK(std::abs(still.center().x - before) < 1e-5);
    // Ground on which forward and backward are alike: what a wave does follows the way that it runs.
    const std::string snake = kSnake + even;
    const Opened forth(snake), back(snake + "control = [{ pace = -1 }]\n");
    forth.run(3);
    back.run(3);
    CHECK(forth.center().x > 0.1);
    CHECK(back.center().x < -0.1);
}

TEST_CASE("a cycle at half the pace is a cycle all the same", "[unit]") {
    const Opened worm(kWorm), slow(kWorm + "control = [{ pace = 0.5 }]\n");
    worm.run(4);
    slow.run(8);
    CHECK(slow.measure("lengths_per_cycle") == Approx(worm.measure("lengths_per_cycle")).epsilon(0.2));
    CHECK(slow.measure("mean_speed_m_s") == Approx(worm.measure("mean_speed_m_s") / 2).epsilon(0.2));
}

TEST_CASE("a script holds for its time and moves the first body alone", "[unit]") {
    const std::string two = kWorm + "count = 2\nspacing = \"10 cm\"\n";
    const Opened free(two), told(two + "control = [{ at = 1, for = 2, pace = 1, turn = 1 }]\n");
    free.run(1);
    told.run(1);
    CHECK(std::equal(free.points().begin(), free.points().end(), told.points().begin()));
    free.run(2);
    told.run(2);
    const auto half = static_cast<std::ptrdiff_t>(free.points().size() / 2);
    CHECK_FALSE(std::equal(free.points().begin(), free.points().begin() + half, told.points().begin()));
    // The second lies where nothing of the first reaches.
    CHECK(std::equal(free.points().begin() + half, free.points().end(), told.points().begin() + half));
}

TEST_CASE("bodies of one table lie apart, crawl alike and are each a creature by the table's name", "[unit]") {
    const Opened three(kWorm + "name = \"brood\"\ncount = 3\nspacing = \"3 cm\"\n"), one(kWorm);
    CHECK(three.measure("crawlers") == 3);
    CHECK(three.measure("particles") == 300);
    CHECK(three.creatures().name() == "brood");
    REQUIRE(three.creatures().positions().size() == 3);
    for (std::size_t body = 0; body < 3; ++body)
        CHECK(distance(three.center(body), {0, 0.003, 0.03 * static_cast<double>(body)}) < 1e-9);
    three.run(2);
    one.run(2);
    for (std::size_t body = 0; body < 3; ++body) {
        const Vec3 way = three.center(body) - Vec3{0, 0, 0.03 * static_cast<double>(body)};
        CHECK(distance(way, one.center()) < 1e-6);
    }
    CHECK(three.measure("work_in_j") == Approx(3 * one.measure("work_in_j")).epsilon(1e-3));
}

TEST_CASE("two tables are two modules of their own names, options and books", "[unit]") {
    const Opened both(kWorm + kSnake + "position = [0, 0, 1]\n"), alone(kWorm);
    CHECK(both.creatures(0).name() == "crawler");
    CHECK(both.creatures(1).name() == "crawler.2");
    both.run(0.5);
    alone.run(0.5);
    CHECK(std::equal(alone.points().begin(), alone.points().end(), both.points().begin()));
    CHECK(both.measure("work_in_j", 0) == alone.measure("work_in_j"));
    CHECK(both.measure("work_in_j", 1) != both.measure("work_in_j", 0));
}

TEST_CASE("who lies upside down stays on the ground and crawls", "[unit]") {
    const Opened worm(kWorm + "upside_down = true\n");
    worm.run(3);
    CHECK(worm.lowest() > -1e-4);
    CHECK(worm.center().y < 0.006);
    CHECK(worm.center().x > 0.005);
    CHECK(worm.measure("max_volume_error") < 0.02);
}

TEST_CASE("who is dropped falls as far as gravity has it, and lands without getting into the floor", "[unit]") {
    const Opened worm(kWorm + "height = \"10 cm\"\n");
    CHECK(worm.lowest() == Approx(0.1));
    worm.run(0.1);
    CHECK(worm.center().y == Approx(0.103 - 9.81 * 0.1 * 0.1 / 2).epsilon(0.01));
    worm.run(0.5);
    CHECK(worm.lowest() > -0.006);
    worm.run(1);
    CHECK(worm.lowest() > -1e-4);
    CHECK(worm.center().y < 0.008);
    const double fallen = worm.measure("body_mass_kg") * 9.81 * 0.1;
    CHECK(worm.measure("impact_loss_j") > 0.2 * fallen);
    const double lost = worm.measure("impact_loss_j") + worm.measure("damping_loss_j");
    CHECK(lost + worm.measure("friction_loss_j") == Approx(fallen + worm.measure("work_in_j")).epsilon(0.02));
}

TEST_CASE("who is laid down in a hollow begins out of the ground, which throws nobody up", "[unit]") {
    const Opened snake("[surface]\nshape = \"height_field\"\nsize = \"2 m\"\nsubdivision = 16\n" + kSnake +
                       "position = [0, 1, 0]\n");
    const Surface& surface = *snake.session->find<Surface>();
    for (const Vec3& p : snake.points()) {
        const SurfaceHit nearest = surface.closest_point(p, 1);
        CHECK(dot(p - surface.position(nearest.at), surface.normal(nearest.at.face)) > -1e-6);
    }
    snake.run(0.25);
    CHECK(snake.measure("energy_gain_j") == 0);
    CHECK(snake.measure("mean_speed_m_s") < 0.05);
}

// Points that looked but once a frame slid through edges of faces, and were lifted out at the next one.
TEST_CASE("a snake over hills is hardly lifted, however long its frames", "[unit]") {
    if (kSanitized) return;
    const char* step = GENERATE("1/60 s", "1/240 s");
    const Opened snake(std::string("[scene]\nstep = \"") + step +
                       "\"\n[surface]\nshape = \"height_field\"\nsize = \"1.2 m\"\nsubdivision = 24\n"
                       "[[crawler]]\nkind = \"snake\"\nposition = [-0.2, 0.04, 0.08]\nheading = [1, 0, 0.1]\n");
    const double frames = 2 / snake.plan.scene.step;
    for (int i = 0; i < frames; ++i) snake.session->step();
    const double work = snake.measure("work_in_j");
    CHECK(work > 0.1);
    CHECK(snake.measure("lift_gain_j") < 0.015 * work);
    CHECK(std::abs(snake.measure("impact_loss_j")) < 0.01 * work);
    CHECK(snake.measure("unexplained_share") < 1e-3);
}

TEST_CASE("who falls onto a surface meets it, however long the steps are that it takes", "[unit]") {
    for (const char* step : {"\"1/60 s\"", "0.001"}) {
        CAPTURE(step);
        const Opened worm(std::string("[surface]\nfloor = \"3 m\"\n[[crawler]]\nkind = \"worm\"\nheight = 4.9\n"
                                      "method = \"implicit_euler\"\nstep = ") +
                          step + "\n");
        worm.run(1.2);
        CHECK(worm.lowest() > -0.006);
    }
}

TEST_CASE("who falls along a wall looks at the floor in time", "[unit]") {
    const Opened worm(
        "[surface]\nshape = \"room\"\nsize = \"1 m\"\n[[crawler]]\nkind = \"worm\"\nheight = \"10 cm\"\n"
        "position = [-0.4905, -0.5, 0]\nheading = [0, 0, 1]\n");
    worm.run(0.5);
    CHECK(worm.lowest() > -0.501);
    CHECK(worm.measure("unexplained_share") < 0.02);
    CHECK(worm.measure("lift_gain_j") < worm.measure("impact_loss_j"));
}

TEST_CASE("a body in the air without gravity goes nowhere: muscles push on nothing", "[unit]") {
    const Opened worm("[scene]\ngravity = [0, 0, 0]\n" + kWorm + "height = \"1 m\"\n");
    worm.run(2);
    CHECK(distance(worm.center(), {0, 1.003, 0}) < 1e-9);
    CHECK(worm.measure("friction_loss_j") == 0);
    CHECK(worm.measure("points_on_ground") == 0);
}

TEST_CASE("books, journey and state of a restored run are those of the run that never stopped", "[unit]") {
    const std::string scene = kWorm + "count = 2\nseek.point = [0.3, 0, -0.3]\n";
    const Opened whole(scene);
    whole.run(1.5);
    const std::string saved = save_snapshot(*whole.session);
    whole.run(1.5);
    Request two;
    two.threads = 2;
    const Opened resumed(scene, two);
    resumed.run(0.1);  // what it had done before is forgotten
    REQUIRE(restore_snapshot(*resumed.session, saved, "saved"));
    resumed.run(1.5);
    CHECK(resumed.session->state_hash() == whole.session->state_hash());
    for (const char* name : {"work_in_j", "friction_loss_j", "impact_loss_j", "damping_loss_j",
                             "energy_change_j", "unexplained_energy_j", "mean_speed_m_s", "lengths_per_cycle",
                             "max_volume_error", "mean_slip_m_s", "points_on_ground", "cost_of_transport"}) {
        CAPTURE(name);
        CHECK(resumed.measure(name) == whole.measure(name));
    }
}

TEST_CASE("what a restored run reports before its next frame is what was saved", "[unit]") {
    const Opened whole(kWorm), resumed(kWorm);
    whole.run(1.5);
    REQUIRE(restore_snapshot(*resumed.session, save_snapshot(*whole.session), "saved"));
    for (const char* name : {"work_in_j", "friction_loss_j", "energy_change_j", "mean_speed_m_s",
                             "max_volume_error", "points_on_ground"}) {
        CAPTURE(name);
        CHECK(resumed.measure(name) == Approx(whole.measure(name)).epsilon(1e-9));
    }
    CHECK(resumed.center() == whole.center());
}

TEST_CASE("a skin is made when somebody asks for it, and changes no state", "[unit]") {
    const Opened seen(kWorm), unseen(kWorm);
    const auto memory = [](const Opened& each) { return each.instance().report().memory_bytes; };
    const std::uint64_t before = memory(seen);
    seen.run(0.1);
    unseen.run(0.1);
    Patches& patches = *seen.session->find<Patches>();
    const PatchLayout layout = patches.layout();
    CHECK(memory(seen) < before + 100'000);
    CHECK(patches.points().size() == layout.bodies * layout.rings * layout.sides);
    CHECK(memory(seen) > before + 100'000);
    seen.run(0.1);
    unseen.run(0.1);
    CHECK(seen.session->state_hash() == unseen.session->state_hash());
}
