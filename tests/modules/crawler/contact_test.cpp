#include "contact.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "ground.hpp"
#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

constexpr double kStep = 1e-3;       // s
constexpr double kAllowance = 1e-6;  // m

Vec3 lane(const Vec3Lanes& v, std::size_t i) { return {v.x[i], v.y[i], v.z[i]}; }
void set(Vec3Lanes& v, std::size_t i, const Vec3& to) { v.x[i] = to.x, v.y[i] = to.y, v.z[i] = to.z; }

/// One point on a level floor, its body along x.
struct Point {
    Vec3 x, v, start, start_v, pressed;
    double holds = 0, grip = 1;
};

struct Met {
    Vec3 x, v, pressed;
    double friction = 0, impact = 0, slip = 0, contacts = 0, lift = 0;
};

/// The point in one lane, others in the other ones, all in a frame of their own: the floor's normal is any.
Met meet(const Point& point, const Friction& friction, bool is_on = true, std::size_t at = 2,
         const Vec3& normal = {0, 1, 0}, const Vec3& forward = {1, 0, 0}) {
    const Vec3 side = cross(forward, normal);
    const auto turned = [&](const Vec3& v) { return v.x * forward + v.y * normal + v.z * side; };
    const auto back = [&](const Vec3& v) { return Vec3{dot(v, forward), dot(v, normal), dot(v, side)}; };
    Touches touch{};
    Landing landing{};
    landing.allowance = kAllowance;
    LaneBits are_on{};
    for (std::size_t i = 0; i < 4; ++i) {
        Point each = point;
        if (i != at) each.v = {-1.0 + static_cast<double>(i), -2, 0.5}, each.x.y = -1e-4;
        set(touch.normal, i, normal);
        touch.depth[i] = -each.x.y;
        touch.grip[i] = i == at ? point.grip : 3;
        set(landing.x, i, turned(each.x)), set(landing.v, i, turned(each.v));
        set(landing.start, i, turned(each.start)), set(landing.start_v, i, turned(each.start_v));
        set(landing.pressed, i, turned(each.pressed));
        set(landing.spine, i, turned({0.3, 0.2, 0}));  // not along the floor, and of no unit length
        landing.holds[i] = each.holds;
        are_on[i] = i != at || is_on ? -1 : 0;
    }
    LandingBooks books;
    meet_ground(touch, are_on, friction, kStep, landing, books);
    return {back(lane(landing.x, at)),
            back(lane(landing.v, at)),
            back(lane(landing.pressed, at)),
            books.friction[at],
            books.impact[at],
            books.slip[at],
            books.contacts[at],
            books.lift[at]};
}

const Friction kScales{FrictionLaw::coulomb, 0.1, 0.4, 0.2};

}  // namespace

TEST_CASE("points are found and put back where they are, two and two", "[unit]") {
    std::vector<double> planes(30);
    std::iota(planes.begin(), planes.end(), 0.0);
    const Four four{10, 2, 7};
    const Vec3Lanes got = four.get_vectors(planes.data());
    const std::size_t points[] = {2, 3, 7, 8};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto p = static_cast<double>(points[i]);
        CHECK(four.point(i) == points[i]);
        CHECK(lane(got, i) == Vec3{p, 10 + p, 20 + p});
    }
    four.put_vectors(got * in_all(-1), planes.data());
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const std::size_t point = i % 10;
        const bool is_one = point == 2 || point == 3 || point == 7 || point == 8;
        CHECK(planes[i] == (is_one ? -1.0 : 1.0) * static_cast<double>(i));
    }
}

TEST_CASE("a ground is asked of every point by its number", "[unit]") {
    struct Numbered {
        Touch touch(const Vec3& p, std::size_t point) const noexcept {
            return {p.x + static_cast<double>(point), {p.y, p.z, 1}, 2.0 * static_cast<double>(point)};
        }
    };
    Vec3Lanes x{Lanes{1, 2, 3, 4}, Lanes{5, 6, 7, 8}, Lanes{9, 10, 11, 12}};
    const Four four{100, 20, 40};
    const Touches all = touch_all(Numbered{}, x, four);
    const double numbers[] = {20, 21, 40, 41};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(all.depth[i] == x.x[i] + numbers[i]);
        CHECK(lane(all.normal, i) == Vec3{x.y[i], x.z[i], 1});
        CHECK(all.grip[i] == 2 * numbers[i]);
    }
}

TEST_CASE("a spine is laid into the plane of the ground, and what stands upright lies anyhow", "[unit]") {
    const RandomStream random(8, "spines");
    std::uint64_t n = 0;
    const auto any = [&] {
        const double x = random.uniform(n++, -1, 1), y = random.uniform(n++, -1, 1);
        return Vec3{x, y, random.uniform(n++, -1, 1)};
    };
    for (int round = 0; round < 200; ++round) {
        Vec3Lanes spine, normal;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 up = any();
            set(normal, i,
                round % 3 == 0 ? Vec3{i % 2 == 0 ? 1.0 : 0.0, i % 2 == 0 ? 0.0 : -1.0, 0} : up / norm(up));
            // Every third time, some have no direction along the ground.
            set(spine, i, round % 3 == 0 && i < 3 ? 2 * lane(normal, i) : any());
        }
        const Vec3Lanes laid = laid_across(spine, normal);
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(norm(lane(laid, i)) == Approx(1).epsilon(1e-12));
            CHECK(std::abs(dot(lane(laid, i), lane(normal, i))) < 1e-12);
            const Vec3 along = across(lane(spine, i), lane(normal, i));
            if (norm(along) > 1e-3) CHECK(distance(lane(laid, i), along / norm(along)) < 1e-12);
        }
    }
}

TEST_CASE("a point that falls is put onto the ground, and stops there for good", "[unit]") {
    Point falling;
    falling.v = {0.3, -1, 0};
    falling.start_v = {0.3, -0.99, 0};  // gravity of 10 m/s^2 in the step
    falling.start = {0, 0.0004, 0};
    falling.x = {0.0003, -0.0006, 0};
    const Met met = meet(falling, kScales);
    CHECK(met.x.y == Approx(-kAllowance).epsilon(1e-9));
    CHECK(met.x.x == 0.0003);
    CHECK(std::abs(met.v.y) < 1e-15);
    CHECK(met.v.x == Approx(0.3 - 0.1 * 1).epsilon(1e-9));  // Coulomb, of the whole impulse
    // It presses on as it is pulled down, and friction holds with the same share.
    CHECK(met.pressed.y == Approx(0.01).epsilon(1e-9));
    CHECK(met.pressed.x == Approx(-0.1 * 0.01).epsilon(1e-9));
    // What it had, less what it was lifted by, against its weight.
    CHECK(met.impact == Approx(0.5 * 1 - 10 * 0.000599).epsilon(1e-9));
    CHECK(met.lift == Approx(10 * 0.000599).epsilon(1e-9));
    CHECK(met.friction == Approx(0.5 * (0.3 * 0.3 - 0.2 * 0.2)).epsilon(1e-9));
    CHECK(met.slip == Approx(0.0003).epsilon(1e-9));
    CHECK(met.contacts == 1);
    falling.grip = 2;
    CHECK(meet(falling, kScales).v.x == Approx(0.3 - 2 * 0.1 * 1).epsilon(1e-9));
}

TEST_CASE("a point that lies stays, borne by the reaction, and nothing is booked", "[unit]") {
    Point lying;
    lying.pressed = {0, 0.01, 0};
    const Met met = meet(lying, kScales);
    CHECK(norm(met.v) < 1e-15);
    CHECK(distance(met.pressed, {0, 0.01, 0}) < 1e-15);
    CHECK(std::abs(met.impact) < 1e-18);
    CHECK(std::abs(met.friction) < 1e-18);
    CHECK(met.contacts == 1);
}

TEST_CASE("a point that is pulled off leaves with what is left, and the reaction's push is taken back",
          "[unit]") {
    Point rising;  // the reaction gave it 0.01 m/s, and it would have flown off without that at 0.02
    rising.v = {0, 0.03, 0};
    rising.start = {0, 0, 0};
    rising.x = {0, 3e-7, 0};
    rising.pressed = {0, 0.01, 0};
    const Met met = meet(rising, kScales);
    CHECK(met.v.y == Approx(0.02).epsilon(1e-12));
    CHECK(norm(met.pressed) < 1e-15);
    // One that has already left keeps its speed; the work that was done on its way is booked.
    rising.x = {2e-6, 3e-5, 0};
    rising.pressed = {-0.002, 0.01, 0};
    rising.start_v = {0.003, 0.025, 0};
    rising.v = {0.001, 0.035, 0};
    const Met left = meet(rising, kScales, false);
    CHECK(left.v == rising.v);
    CHECK(left.x == rising.x);
    CHECK(norm(left.pressed) == 0);
    CHECK(left.impact == Approx(-0.01 * 3e-5 / kStep).epsilon(1e-9));
    CHECK(left.friction == Approx(0.002 * 2e-6 / kStep).epsilon(1e-9));
    CHECK(left.slip == 0);
    CHECK(left.contacts == 0);
}

TEST_CASE("what holds on is torn off by more than it holds with, and rubs by that too", "[unit]") {
    Point held;
    held.holds = 0.05;
    held.v = {0, 0.03, 0};
    Met met = meet(held, kScales);
    CHECK(std::abs(met.v.y) < 1e-15);
    CHECK(met.pressed.y == Approx(-0.03).epsilon(1e-12));  // it is held back so from now on
    held.v = {0, 0.08, 0};
    met = meet(held, kScales);
    CHECK(met.v.y == Approx(0.03).epsilon(1e-12));
    // Without any weight, by friction of 0.05 m/s, sideways 0.2.
    held.v = {0, 0, 1};
    met = meet(held, kScales);
    CHECK(met.v.z == Approx(1 - 0.2 * 0.05).epsilon(1e-9));
}

TEST_CASE("points are met in their own lanes, on a ground that faces anywhere", "[unit]") {
    const RandomStream random(12, "meetings");
    std::uint64_t n = 0;
    const auto any = [&](double size) {
        const double x = random.uniform(n++, -size, size), y = random.uniform(n++, -size, size);
        return Vec3{x, y, random.uniform(n++, -size, size)};
    };
    const Vec3 normal{0.48, 0.6, 0.64}, forward{0.8, 0, -0.6};
    for (int round = 0; round < 500; ++round) {
        Point point{{0, random.uniform(n++, -1e-3, 0), 0}, any(1), any(1e-3), any(1), any(0.1), 0, 1};
        point.pressed.y = std::abs(point.pressed.y);
        const Met level = meet(point, kScales, true, 0);
        for (std::size_t at = 0; at < 4; ++at) {
            const Met leaning = meet(point, kScales, true, at, normal, forward);
            CHECK(distance(level.x, leaning.x) < 1e-12);
            CHECK(distance(level.v, leaning.v) < 1e-9);  // the end speed's tolerance
            CHECK(distance(level.pressed, leaning.pressed) < 1e-9);
            CHECK(level.friction == Approx(leaning.friction).margin(1e-9));
            CHECK(level.impact == Approx(leaning.impact).margin(1e-9));
            CHECK(level.slip == Approx(leaning.slip).margin(1e-12));
        }
        // By hand: the way of Coulomb, across the normal without the reaction, and Signorini along it.
        const double pressing = std::max(0.0, point.pressed.y - point.v.y);
        const Vec3 free{point.v.x - point.pressed.x, 0, point.v.z - point.pressed.z};
        CHECK(level.v.y == Approx(point.v.y - point.pressed.y + pressing).margin(1e-12));
        const double speed = norm(Vec3{level.v.x, 0, level.v.z});
        if (speed == 0) {
            const double mu = free.x < 0 ? 0.4 : 0.1;
            CHECK(std::hypot(free.x / mu, free.z / 0.2) <= pressing * (1 + 1e-12));
        } else {
            const double mu = level.v.x < 0 ? 0.4 : 0.1;
            CHECK(level.v.x + pressing * mu * level.v.x / speed == Approx(free.x).margin(1e-9));
            CHECK(level.v.z + pressing * 0.2 * level.v.z / speed == Approx(free.z).margin(1e-9));
        }
    }
}

TEST_CASE("books leave out lanes that are there twice", "[unit]") {
    LandingBooks sum;
    LandingBooks more;
    more.friction = Lanes{1, 2, 3, 4};
    more.impact = Lanes{5, 6, 7, 8};
    more.slip = Lanes{9, 10, 11, 12};
    more.contacts = Lanes{1, 1, 1, 1};
    more.lift = Lanes{2, 4, 6, 8};
    more.damping = Lanes{1, 3, 5, 7};
    more.lagging = Lanes{3, 5, 7, 9};
    sum.add(more, true);
    sum.add(more, false);
    CHECK(crawler::sum(sum.friction) == 13);
    CHECK(crawler::sum(sum.impact) == 37);
    CHECK(crawler::sum(sum.slip) == 61);
    CHECK(crawler::sum(sum.contacts) == 6);
    CHECK(crawler::sum(sum.lift) == 26);
    CHECK(crawler::sum(sum.damping) == 20);
    CHECK(crawler::sum(sum.lagging) == 32);
}

// Leapfrogged, a linear spring keeps the energy whose kinetic part is v v'/2 of the velocities v and v' on both
// sides of a position. By how much the ground changes it, at a step of nearly half of the longest stable one,
// is what it books.
TEST_CASE("where forces act where steps begin, books are of the energy that leapfrogging keeps", "[unit]") {
    const double omega = 0.9 / kStep;
    const Lanes tug = in_all(-kStep * omega * omega);
    const Vec3Lanes middle{Lanes{}, Lanes{-1e-4, 1e-4, 2e-5, -3e-5}, Lanes{}};
    const auto kick = [&](const Vec3Lanes& x) { return (x - middle) * tug; };
    const auto kept = [&](const Vec3Lanes& x, const Vec3Lanes& v) {
        const Vec3Lanes way = x - middle;
        return 0.5 * (dot(v, v + kick(x)) + omega * omega * dot(way, way));
    };
    Landing points{};
    points.x = {Lanes{1e-3, 0, 2e-3, -1e-3}, in_all(1e-4), Lanes{0, 1e-3, 1e-3, 2e-3}};
    points.v = {Lanes{0.1, -0.2, 0.3, 0}, Lanes{-1, 0.3, -0.2, 0}, Lanes{0, 0.3, 0, 0.1}};
    points.spine = {in_all(1), Lanes{}, Lanes{}};
    points.allowance = kAllowance;
    points.weighed = {0, -1e-3, 0};
    points.lag = points.velocity_lag = 0.5;
    points.are_damped = true;
    const Lanes start = kept(points.x, points.v);
    LandingBooks books;
    for (int step = 0; step < 300; ++step) {
        points.start = points.x, points.start_v = points.v;
        points.v = points.v + kick(points.x) + points.pressed;
        points.x = points.x + points.v * in_all(kStep);
        const Touches touch{-points.x.y, {Lanes{}, in_all(1), Lanes{}}, in_all(1)};
        const LaneBits was_pressed = dot(points.pressed, points.pressed) > Lanes{};
        const LaneBits is_near = touch.depth > in_all(-points.allowance);
        meet_ground(touch, is_near & (was_pressed | (touch.depth > Lanes{})), kScales, kStep, points, books);
    }
    const Lanes pending = 0.5 * dot(kick(points.x), points.turned);  // the next step would book it
    const Lanes left =
        kept(points.x, points.v) - start + books.friction + books.impact + books.damping - pending;
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(books.contacts[i] > 40);
        CHECK(books.friction[i] > 1e-3 * start[i]);
        CHECK(std::abs(left[i]) < 1e-11 * start[i]);
        CHECK(std::abs(books.lagging[i]) > 1e-6 * start[i]);
    }
    CHECK(std::abs(crawler::sum(books.damping)) > 1e-3 * crawler::sum(start));
}
