#include "crawl.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::crawler {

using mass_spring::Packing;

namespace {

/// Widths of the body around the ground's surface within which a point that it presses is on it: were every
/// point put exactly there, springs would be strained anew in every step.
constexpr double kNear = 1e-4;

Effort between(const Effort& a, const Effort& b, double share) noexcept {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.strain, b.strain), mix(a.bend, b.bend), mix(a.lift, b.lift), mix(a.turn, b.turn)};
}

Vec3 at(const double* planes, const Packing& packing, std::size_t point) noexcept {
    const std::size_t i = packing.place(point), plane = packing.plane();
    return {planes[i], planes[plane + i], planes[2 * plane + i]};
}

void put(const Vec3& to, double* planes, const Packing& packing, std::size_t point) noexcept {
    const std::size_t i = packing.place(point), plane = packing.plane();
    planes[i] = to.x, planes[plane + i] = to.y, planes[2 * plane + i] = to.z;
}

/// Along the body at a ring, from the middles of its neighbors (Miller's local spine vector), in the plane of
/// the ground there. Where that has none, nothing tells forward from sideways.
Vec3 spine_at(std::span<const Vec3> middles, std::uint32_t ring, const Vec3& normal) noexcept {
    const std::size_t before = ring > 0 ? ring - 1 : 0;
    const std::size_t after = std::min<std::size_t>(ring + 1, middles.size() - 1);
    const Vec3 along = across(middles[after] - middles[before], normal);
    const double length = norm(along);
    if (length > 0) return along / length;
    const Vec3 any = across(std::abs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}, normal);
    return any / norm(any);
}

}  // namespace

Books& Books::operator+=(const Books& o) noexcept {
    muscles += o.muscles;
    friction += o.friction;
    impact += o.impact;
    damping += o.damping;
    slip += o.slip;
    contact += o.contact;
    return *this;
}

Crawl::Crawl(mass_spring::SpringSystem& system, mass_spring::Network& network, const Lattice& lattice,
             const Build& build, const Waves& waves, const Friction& friction, Ground ground,
             std::span<Vec3> reaction, double lag, Workers* workers)
    : system_(&system),
      network_(&network),
      lattice_(lattice),
      build_(build),
      waves_(waves),
      friction_(friction),
      ground_(std::move(ground)),
      workers_(workers),
      drives_(lattice.bodies),
      frame_(lattice.bodies),
      kept_(lattice.bodies),
      lag_(lag),
      reaction_(reaction),
      start_reaction_(reaction.size()),
      scratch_(lattice.bodies,
               {std::vector<Flex>(lattice.segments), std::vector<double>(lattice.springs_a_body()),
                std::vector<Vec3>(lattice.rings()), Muscles(build)}) {}

template <class F>
void Crawl::for_each_body(const F& f) noexcept {
    auto range = [&](std::size_t begin, std::size_t end) {
        for (std::size_t body = begin; body < end; ++body) f(static_cast<std::uint32_t>(body));
    };
    if (workers_ != nullptr)
        workers_->for_each_range(lattice_.bodies, 4, range);
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
    system_->packing().pack(start_reaction_, system_->hook_forces());
    frame_.assign(frame_.size(), {});
    for_each_body([&](std::uint32_t body) {
        Scratch& scratch = scratch_[body];
        set_lengths(body, 0, scratch);
        const std::size_t first = lattice_.ring_spring(body, 0);
        for (std::size_t i = 0; i < scratch.rest.size(); ++i)
            network_->springs[first + i].rest_length = scratch.rest[i];
    });
    system_->rest_lengths_changed();
}

void Crawl::set_lengths(std::uint32_t body, double share, Scratch& scratch) noexcept {
    const Drive& drive = drives_[body];
    waves_.flex(std::lerp(drive.cycles[0], drive.cycles[1], share),
                between(drive.effort[0], drive.effort[1], share), scratch.flexes);
    scratch.muscles.lengths(scratch.flexes, scratch.rest);
}

void Crawl::before_step(std::span<const double> x, std::span<const double> v, double h) noexcept {
    start_x_.assign(x.begin(), x.end());
    start_v_.assign(v.begin(), v.end());
    for_each_body([&](std::uint32_t body) { flex(body, x.data(), v.data(), h, scratch_[body]); });
    system_->rest_lengths_changed();
}

// Springs get the lengths of the step's end. What muscles do is how much more the springs hold for it, at
// positions as old as the velocities: it is there that a method with a lag keeps energy.
void Crawl::flex(std::uint32_t body, const double* x, const double* v, double h, Scratch& scratch) noexcept {
    set_lengths(body, std::min(1.0, (elapsed_ + h) / seconds_), scratch);
    const Packing& packing = system_->packing();
    const std::size_t first = lattice_.ring_spring(body, 0);
    double doubled_work = 0, power = 0;
    for (std::size_t i = 0; i < scratch.rest.size(); ++i) {
        mass_spring::Spring& spring = network_->springs[first + i];
        const Vec3 l = at(x, packing, spring.a) - at(x, packing, spring.b);
        const Vec3 moving = at(v, packing, spring.a) - at(v, packing, spring.b);
        const double square = dot(l, l), rate = dot(l, moving);
        const double before = spring.rest_length, after = scratch.rest[i];
        doubled_work +=
            spring.stiffness * (after - before) * (after + before - 2 * norm(l - lag_ * h * moving));
        if (square > 0) power += spring.damping * rate * rate / square;
        spring.rest_length = after;
    }
    frame_[body].muscles += doubled_work / 2;
    frame_[body].damping += h * power;
}

void Crawl::after_step(std::span<double> x, std::span<double> v, double h) noexcept {
    elapsed_ += h;
    std::visit(
        [&](const auto& ground) {
            for_each_body(
                [&](std::uint32_t body) { meet(ground, body, x.data(), v.data(), h, scratch_[body]); });
        },
        ground_);
}

/// m/s^2, that it takes to tear a ring's points off: nothing where both its segments, or one at an end, hump.
double Crawl::holds(std::uint32_t ring, const Scratch& scratch) const noexcept {
    if (!(friction_.adhesion > 0)) return 0;
    const double before = scratch.flexes[ring > 0 ? ring - 1 : 0].up;
    const double after = scratch.flexes[std::min<std::size_t>(ring, scratch.flexes.size() - 1)].up;
    return before + after < 0 ? 0 : friction_.adhesion;
}

template <class AnyGround>
void Crawl::meet(const AnyGround& ground, std::uint32_t body, double* x, double* v, double h,
                 Scratch& scratch) noexcept {
    const Packing& packing = system_->packing();
    double* force = system_->hook_forces().data();
    for (std::uint32_t ring = 0; ring < lattice_.rings(); ++ring) {
        Vec3 sum;
        for (std::uint32_t j = 0; j < kCorners; ++j) sum += at(x, packing, lattice_.point(body, ring) + j);
        scratch.middles[ring] = 0.25 * sum;
    }
    const double near = kNear * build_.width;
    for (std::uint32_t ring = 0; ring < lattice_.rings(); ++ring) {
        const double held = h * holds(ring, scratch);
        for (std::uint32_t j = 0; j < kCorners; ++j) {
            const std::size_t i = lattice_.point(body, ring) + j;
            Point point;
            point.x = at(x, packing, i);
            const Touch touch = ground.touch(point.x, i);
            const Vec3 pressed = at(force, packing, i);
            const bool was_pressed = dot(pressed, pressed) > 0;
            if (!(touch.depth > (was_pressed || held > 0 ? -near : 0))) {
                if (was_pressed) {
                    const Vec3 moved = point.x - at(start_x_.data(), packing, i);
                    const double normal_work = dot(pressed, touch.normal) * dot(touch.normal, moved);
                    frame_[body].impact -= normal_work;
                    frame_[body].friction -= dot(pressed, moved) - normal_work;
                    put({}, force, packing, i);
                }
                continue;
            }
            point.mass = network_->mass[i];
            point.holds = held;
            point.v = at(v, packing, i);
            point.start = at(start_x_.data(), packing, i);
            point.start_v = at(start_v_.data(), packing, i);
            point.pressed = h / point.mass * pressed;
            point.spine = spine_at(scratch.middles, ring, touch.normal);
            meet_point(touch, h, point, frame_[body]);
            put(point.x, x, packing, i);
            put(point.v, v, packing, i);
            put(point.mass / h * point.pressed, force, packing, i);
        }
    }
}

void Crawl::meet_point(const Touch& touch, double h, Point& point, Books& books) const noexcept {
    const Vec3& n = touch.normal;
    const Vec3 moved = point.x - point.start;
    const double into = dot(point.v, n), pressed = dot(point.pressed, n);
    const Vec3 along = across(point.v, n), held = across(point.pressed, n);
    const double pressing = std::max(-point.holds, pressed - into);
    const double left = into + pressing - pressed;
    const Vec3 free = along - held;  // without friction
    const Vec3 slid =
        slide(friction_, touch.grip * (pressing + point.holds), free, point.spine, cross(n, point.spine));
    const double lifted = std::max(0.0, touch.depth - kNear * build_.width);
    // What all but the ground gave it into the ground; the rest of what is taken is its fall.
    const double weighed = pressed - into + dot(point.start_v, n);
    // The reaction did work on the way; the impulse turned the rest. What lifts the point works against what
    // presses it down.
    books.friction -= point.mass * (dot(held, moved) / h + 0.5 * (dot(slid, slid) - dot(along, along)));
    books.impact -=
        point.mass * (pressed * dot(n, moved) / h + 0.5 * (left * left - into * into) + weighed * lifted / h);
    books.slip += norm(across(moved, n));
    books.contact += h;
    point.x += lifted * n;
    point.v = slid + left * n;
    // A fall ends here: the ground goes on to press as it does without.
    const double lasting = pressing > 0 ? std::clamp(weighed / pressing, 0.0, 1.0) : 1;
    point.pressed = lasting * (pressing * n + slid - free);
}

double Crawl::work() const noexcept {
    double sum = 0;
    for (const Books& each : frame_) sum += each.muscles - each.friction - each.impact;
    return sum;
}

double Crawl::turnover() const noexcept {
    double sum = 0;
    for (const Books& each : frame_) sum += std::abs(each.muscles) + each.friction + std::abs(each.impact);
    return sum;
}

void Crawl::keep() noexcept {
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] += frame_[i];
    system_->packing().unpack(system_->hook_forces(), reaction_);
}

std::size_t Crawl::memory_bytes() const noexcept {
    std::size_t bytes = (frame_.capacity() + kept_.capacity()) * sizeof(Books) +
                        drives_.capacity() * sizeof(Drive) +
                        network_->springs.capacity() * sizeof(mass_spring::Spring);
    for (const Scratch& each : scratch_)
        bytes += sizeof(Scratch) + each.flexes.capacity() * sizeof(Flex) +
                 (each.rest.capacity() + each.flexes.size() + 1) * sizeof(double) +
                 each.middles.capacity() * sizeof(Vec3);
    if (const auto* surface = std::get_if<SurfaceGround>(&ground_)) bytes += surface->memory_bytes();
    return bytes;
}

}  // namespace orbweaver::crawler
