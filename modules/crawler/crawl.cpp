#include "crawl.hpp"

#include <algorithm>
#include <cmath>

#include "mass_spring/lanes.hpp"

namespace orbweaver::crawler {

using mass_spring::load, mass_spring::store, mass_spring::Vec3Lanes;

namespace {

/// Widths of the body around the ground's surface within which a point that it presses is on it: were every
/// point put exactly there, springs would be strained anew in every step.
constexpr double kNear = 1e-4;

Effort between(const Effort& a, const Effort& b, double share) noexcept {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.strain, b.strain), mix(a.bend, b.bend), mix(a.lift, b.lift), mix(a.turn, b.turn)};
}

/// Along the body at a ring, from the middles of its neighbors (Miller's local spine vector).
Vec3 spine_at(std::span<const Vec3> middles, std::size_t ring) noexcept {
    const std::size_t before = ring > 0 ? ring - 1 : 0;
    const std::size_t after = std::min(ring + 1, middles.size() - 1);
    return middles[after] - middles[before];
}

/// Whether muscles hump a ring: then it holds on to nothing.
bool is_lifted(std::span<const Flex> flexes, std::size_t ring) noexcept {
    return flexes[ring > 0 ? ring - 1 : 0].up + flexes[std::min(ring, flexes.size() - 1)].up < 0;
}

ORBWEAVER_INLINE double sum(const Lanes& of) noexcept { return (of[0] + of[1]) + (of[2] + of[3]); }
ORBWEAVER_INLINE Vec3Lanes in_all(const Vec3& v) noexcept {
    return {orbweaver::in_all(v.x), orbweaver::in_all(v.y), orbweaver::in_all(v.z)};
}
ORBWEAVER_INLINE Vec3Lanes either(const LaneBits& first, const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}
ORBWEAVER_INLINE Vec3Lanes crossed(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The four points of a ring with regard to the ground.
struct RingTouch {
    Lanes depth;       ///< m
    Vec3Lanes normal;  ///< unit
    Lanes grip;
};

template <class AnyGround>
ORBWEAVER_INLINE RingTouch touch_ring(const AnyGround& ground, const Vec3Lanes& x, std::size_t first) noexcept {
    RingTouch ring;
    for (std::size_t j = 0; j < kCorners; ++j) {
        const Touch touch = ground.touch({x.x[j], x.y[j], x.z[j]}, first + j);
        ring.depth[j] = touch.depth;
        ring.normal.x[j] = touch.normal.x, ring.normal.y[j] = touch.normal.y, ring.normal.z[j] = touch.normal.z;
        ring.grip[j] = touch.grip;
    }
    return ring;
}

/// In the plane across a normal, of length 1. Where it has nothing there, nothing tells forward from sideways.
ORBWEAVER_INLINE Vec3Lanes laid_across(const Vec3& spine, const Vec3Lanes& normal) noexcept {
    const auto without = [&](const Vec3Lanes& v)
                             ORBWEAVER_ALWAYS_INLINE { return v - normal * dot(v, normal); };
    const Vec3Lanes along = without(in_all(spine));
    const Lanes square = dot(along, along);
    const LaneBits is_steep = absolute(normal.x) < orbweaver::in_all(0.5);
    const Vec3Lanes any = without(either(is_steep, in_all(Vec3{1, 0, 0}), in_all(Vec3{0, 0, 1})));
    const Vec3Lanes chosen = either(square > Lanes{}, along, any);
    return chosen * (1 / mass_spring::sqrt(dot(chosen, chosen)));
}

/// A ring after a step of h seconds.
struct Ring {
    Vec3Lanes x, v;        ///< m, m/s
    Vec3Lanes start;       ///< m, before the step
    Vec3Lanes pressed;     ///< m/s, what the ground's reaction gave it during the step
    Lanes mass;            ///< kg
    double holds = 0;      ///< m/s, what it takes to tear it off
    double allowance = 0;  ///< m, deep in the ground within which it may stay
};

struct RingBooks {
    Lanes friction{}, impact{}, slip{}, contacts{};
};

/// Those of its points that `are_on` the ground are met by it.
ORBWEAVER_INLINE void meet_ground(const RingTouch& touch, const LaneBits& are_on, const Friction& friction,
                                  const Vec3& spine_vector, double h, Ring& ring, RingBooks& books) noexcept {
    const Vec3Lanes n = touch.normal, moved = ring.x - ring.start;
    const Vec3Lanes spine = laid_across(spine_vector, n), side = crossed(n, spine);
    const Lanes into = dot(ring.v, n), pressed = dot(ring.pressed, n), on_way = dot(moved, n);
    const Vec3Lanes along = ring.v - n * into, held = ring.pressed - n * pressed;
    const Lanes pressing = larger_of(orbweaver::in_all(-ring.holds), pressed - into);
    const Lanes left = into + pressing - pressed;
    const Vec3Lanes free = along - held;  // without friction
    const Sliding slid = slide(friction, touch.grip * (pressing + ring.holds),
                               {are_on ? dot(free, spine) : Lanes{}, are_on ? dot(free, side) : Lanes{}});
    const Vec3Lanes slides = spine * slid.along + side * slid.across;
    const Lanes lifted = larger_of(touch.depth - ring.allowance, Lanes{});
    // The reaction did work on the way; the impulse turned the rest. What lifts the point works against what
    // presses it down.
    const Lanes by_friction =
        ring.mass * (dot(held, moved) / h + 0.5 * (dot(slides, slides) - dot(along, along)));
    const Lanes by_impact =
        ring.mass * (pressed * on_way / h + 0.5 * (left * left - into * into) + pressing * lifted / h);
    const Vec3Lanes slip = moved - n * on_way;
    books.friction -= are_on ? by_friction : Lanes{};
    books.impact -= are_on ? by_impact : Lanes{};
    books.slip += are_on ? mass_spring::sqrt(dot(slip, slip)) : Lanes{};
    books.contacts += are_on ? orbweaver::in_all(1) : Lanes{};
    ring.x = either(are_on, ring.x + n * lifted, ring.x);
    ring.v = either(are_on, slides + n * left, ring.v);
    ring.pressed = either(are_on, n * pressing + slides - free, ring.pressed);
}

}  // namespace

Books& Books::operator+=(const Books& o) noexcept {
    muscles += o.muscles;
    damping += o.damping;
    friction += o.friction;
    impact += o.impact;
    slip += o.slip;
    contact += o.contact;
    return *this;
}

Crawl::Crawl(mass_spring::SpringSystem& system, const Lattice& lattice, const Build& build, const Waves& waves,
             const Friction& friction, Ground ground, std::span<Vec3> reaction, double lag, Workers* workers)
    : system_(&system),
      lattice_(lattice),
      build_(build),
      waves_(waves),
      friction_(friction),
      ground_(std::move(ground)),
      workers_(workers),
      lag_(lag),
      reaction_(reaction),
      start_reaction_(reaction.size()),
      drives_(lattice.bodies),
      bodies_(lattice.bodies, {Muscles(build),
                               std::vector<Flex>(lattice.segments),
                               std::vector<double>(lattice.springs_a_body()),
                               std::vector<Vec3>(lattice.rings()),
                               {}}) {
    system.set_hooks(this);
}

template <class F>
void Crawl::for_each_body(const F& f) noexcept {
    constexpr std::size_t kGrain = 4;
    auto range = [&](std::size_t begin, std::size_t end) {
        for (std::size_t body = begin; body < end; ++body) f(static_cast<std::uint32_t>(body));
    };
    if (workers_ != nullptr)
        workers_->for_each_range(lattice_.bodies, kGrain, range);
    else
        range(0, lattice_.bodies);
}

void Crawl::begin_frame(std::span<const Drive> drives, std::span<const Vec3> x, std::span<const Vec3> v,
                        double seconds) {
    std::copy(drives.begin(), drives.end(), drives_.begin());
    seconds_ = seconds;
    std::copy(reaction_.begin(), reaction_.end(), start_reaction_.begin());
    if (auto* surface = std::get_if<SurfaceGround>(&ground_)) surface->look(x, v, seconds);
}

void Crawl::rewind() noexcept {
    elapsed_ = 0;
    frame_ = {};
    for (Body& body : bodies_) body.frame = {};
    system_->packing().pack(start_reaction_, system_->hook_forces());
    for_each_body([&](std::uint32_t body) { find_lengths(body, 0); });
    system_->set_rest_lengths();
}

void Crawl::find_lengths(std::uint32_t number, double share) noexcept {
    const Drive& drive = drives_[number];
    Body& body = bodies_[number];
    waves_.flex(std::lerp(drive.cycles[0], drive.cycles[1], share),
                between(drive.effort[0], drive.effort[1], share), body.flexes);
    body.muscles.lengths(body.flexes, body.rest);
    const std::size_t first = lattice_.ring_spring(number, 0);
    double* next = system_->next_rest_lengths().data();
    for (std::size_t i = 0; i < body.rest.size(); ++i) next[system_->rest_place(first + i)] = body.rest[i];
}

// Springs get the lengths of the step's end.
void Crawl::before_step(std::span<const double> x, std::span<const double> v, double h) noexcept {
    start_x_.assign(x.begin(), x.end());
    const double share = std::min(1.0, (elapsed_ + h) / seconds_);
    for_each_body([&](std::uint32_t body) { find_lengths(body, share); });
    const mass_spring::DriveWork done = system_->drive(x, v, lag_ * h);
    frame_.muscles += done.work;
    frame_.damping += h * done.damping;
}

void Crawl::after_step(std::span<double> x, std::span<double> v, double h) noexcept {
    elapsed_ += h;
    std::visit(
        [&](const auto& ground) { for_each_body([&](std::uint32_t body) { meet(ground, body, x, v, h); }); },
        ground_);
}

template <class AnyGround>
void Crawl::meet(const AnyGround& ground, std::uint32_t number, std::span<double> x, std::span<double> v,
                 double h) noexcept {
    Body& body = bodies_[number];
    const std::size_t plane = system_->packing().plane(), first = lattice_.point(number, 0);
    for (std::uint32_t ring = 0; ring < lattice_.rings(); ++ring) {
        const Vec3Lanes at = load(x.data() + first + std::size_t{kCorners} * ring, plane);
        body.middles[ring] = 0.25 * Vec3{sum(at.x), sum(at.y), sum(at.z)};
    }
    const double near = kNear * build_.width;
    double* const reactions = system_->hook_forces().data();
    const double* const mass = system_->network().mass.data();
    RingBooks books;
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE {
        for (std::size_t ring = 0; ring < body.middles.size(); ++ring) {
            const std::size_t i = first + kCorners * ring;
            const Vec3Lanes place = load(x.data() + i, plane);
            const RingTouch touch = touch_ring(ground, place, i);
            const LaneBits is_near = touch.depth > orbweaver::in_all(-near);
            if (!is_any(is_near)) {
                store(reactions + i, plane, Vec3Lanes{});
                continue;
            }
            const bool holds = friction_.adhesion > 0 && !is_lifted(body.flexes, ring);
            const Vec3Lanes reaction = load(reactions + i, plane);
            const LaneBits was_on = dot(reaction, reaction) > orbweaver::in_all(holds ? -1 : 0);
            const LaneBits are_on = is_near & (was_on | (touch.depth > Lanes{}));
            const Lanes masses = load(mass + i);
            Ring points{place,
                        load(v.data() + i, plane),
                        load(start_x_.data() + i, plane),
                        either(is_near, reaction, Vec3Lanes{}) * (h / masses),
                        masses,
                        holds ? h * friction_.adhesion : 0,
                        near};
            meet_ground(touch, are_on, friction_, spine_at(body.middles, ring), h, points, books);
            store(x.data() + i, plane, points.x);
            store(v.data() + i, plane, points.v);
            store(reactions + i, plane, points.pressed * (masses / h));
        }
    });
    body.frame.friction += sum(books.friction);
    body.frame.impact += sum(books.impact);
    body.frame.slip += sum(books.slip);
    body.frame.contact += h * sum(books.contacts);
}

double Crawl::work() const noexcept {
    double sum = frame_.muscles;
    for (const Body& body : bodies_) sum -= body.frame.friction + body.frame.impact;
    return sum;
}

double Crawl::turnover() const noexcept {
    double sum = std::abs(frame_.muscles);
    for (const Body& body : bodies_) sum += std::abs(body.frame.friction) + std::abs(body.frame.impact);
    return sum;
}

void Crawl::keep() noexcept {
    kept_ += frame_;
    for (const Body& body : bodies_) kept_ += body.frame;
    system_->packing().unpack(system_->hook_forces(), reaction_);
}

std::size_t Crawl::memory_bytes() const noexcept {
    std::size_t bytes = drives_.capacity() * sizeof(Drive) + start_reaction_.capacity() * sizeof(Vec3) +
                        start_x_.capacity() * sizeof(double);
    for (const Body& body : bodies_)
        bytes += sizeof(Body) + body.flexes.capacity() * sizeof(Flex) +
                 (body.rest.capacity() + lattice_.rings()) * sizeof(double) +
                 body.middles.capacity() * sizeof(Vec3);
    if (const auto* surface = std::get_if<SurfaceGround>(&ground_)) bytes += surface->memory_bytes();
    return bytes;
}

}  // namespace orbweaver::crawler
