#include "crawl.hpp"

#include <algorithm>
#include <cmath>

#include "contact.hpp"

namespace orbweaver::crawler {

namespace {

/// Widths of the body around the ground's surface within which a point that it presses is on it: were every
/// point put exactly there, springs would be strained anew in every step.
constexpr double kNear = 1e-4;
/// Likewise, how far feet reach that hold on to the ground.
constexpr double kReach = 0.05;

Effort between(const Effort& a, const Effort& b, double share) noexcept {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.strain, b.strain), mix(a.bend, b.bend), mix(a.lift, b.lift), mix(a.turn, b.turn)};
}

/// How many stretches of a frame lengths change evenly in. Those of a sine are then within 0.05 % of its
/// height; those of square waves change at once, or as good as that.
std::size_t count_stretches(WaveForm form, std::span<const Drive> drives) noexcept {
    constexpr double kACycle = 100, kMost = 1e6;
    if (form != WaveForm::sine) return static_cast<std::size_t>(kMost);
    double cycles = 0;
    for (const Drive& drive : drives) cycles = std::max(cycles, std::abs(drive.cycles[1] - drive.cycles[0]));
    return static_cast<std::size_t>(std::clamp(std::ceil(kACycle * cycles), 1.0, kMost));
}

/// How often points look at a surface in a frame: often enough that none goes far meanwhile, beside the body's
/// width, unless it flies.
std::size_t count_looks(std::span<const Vec3> v, double seconds, double width) noexcept {
    constexpr double kFar = 1.0 / 16, kMost = 16;
    double square = 0;
    for (const Vec3& each : v) square = std::max(square, dot(each, each));
    return static_cast<std::size_t>(
        std::clamp(std::ceil(std::sqrt(square) * seconds / (kFar * width)), 1.0, kMost));
}

/// Along the body at a ring, from the middles of its neighbors (Miller's local spine vector).
Vec3 spine_at(std::span<const Vec3> middles, std::size_t ring) noexcept {
    const std::size_t before = ring > 0 ? ring - 1 : 0;
    const std::size_t after = std::min(ring + 1, middles.size() - 1);
    return middles[after] - middles[before];
}

}  // namespace

Books& Books::operator+=(const Books& o) noexcept {
    muscles += o.muscles;
    damping += o.damping;
    friction += o.friction;
    impact += o.impact;
    lift += o.lift;
    slip += o.slip;
    contact += o.contact;
    lagging += o.lagging;
    return *this;
}

Crawl::Crawl(mass_spring::SpringSystem& system, const Lattice& lattice, const Build& build, const Waves& waves,
             const Friction& friction, Ground ground, const StepTrace& trace,
             const mass_spring::MethodInfo& method, Workers* workers)
    : system_(&system),
      lattice_(lattice),
      build_(build),
      waves_(waves),
      friction_(friction),
      ground_(std::move(ground)),
      workers_(workers),
      method_(&method),
      trace_{trace.reaction, trace.turned, trace.x, trace.v},
      start_x_(system.length()),
      start_v_(system.length()),
      turned_(system.length()),
      look_x_(std::holds_alternative<SurfaceGround>(ground_) ? lattice.points() : 0),
      look_v_(look_x_.size()),
      drives_(lattice.bodies),
      bodies_(lattice.bodies, {Muscles(build),
                               std::vector<Flex>(lattice.segments),
                               std::vector<double>(lattice.springs_a_body()),
                               std::vector<Vec3>(lattice.rings()),
                               std::vector<std::uint8_t>(lattice.rings() + 1),
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

// As std::visit, which may throw.
template <class F>
void Crawl::with_ground(const F& f) noexcept {
    if (const auto* floor = std::get_if<Floor>(&ground_)) f(*floor);
    if (const auto* cliff = std::get_if<Cliff>(&ground_)) f(*cliff);
    if (SurfaceGround* surface = surface_ground()) f(*surface);
}

// Out of one face it may be into the next.
void Crawl::lift_out(std::span<Vec3> x) {
    constexpr int kPasses = 4;
    const std::vector<Vec3> still(x.size());
    for (int pass = 0; pass < kPasses; ++pass) {
        if (SurfaceGround* surface = surface_ground()) surface->look(x, still, 0);
        with_ground([&](const auto& ground) {
            for (std::size_t i = 0; i < x.size(); ++i) {
                const Touch touch = ground.touch(x[i], i);
                if (touch.depth > 0) x[i] += touch.depth * touch.normal;
            }
        });
    }
}

void Crawl::lay_down(std::span<const Vec3> x) {
    const auto& springs = system_->network().springs;
    laid_.resize(springs.size());
    for (std::size_t i = 0; i < springs.size(); ++i) laid_[i] = distance(x[springs[i].a], x[springs[i].b]);
}

void Crawl::begin_frame(std::span<const Drive> drives, std::span<const Vec3> x, std::span<const Vec3> v,
                        double seconds) {
    std::copy(drives.begin(), drives.end(), drives_.begin());
    stretches_ = count_stretches(waves_.form(), drives);
    seconds_ = seconds;
    for (std::size_t i = 0; i < trace_.size(); ++i) start_trace_[i].assign(trace_[i].begin(), trace_[i].end());
    if (SurfaceGround* surface = surface_ground()) {
        looks_ = count_looks(v, seconds, build_.width);
        surface->look(x, v, seconds);
        surface->mark();
    }
}

void Crawl::look_again(std::span<const double> x, std::span<const double> v) noexcept {
    SurfaceGround* surface = surface_ground();
    if (surface == nullptr) return;
    system_->packing().unpack(x, look_x_);
    system_->packing().unpack(v, look_v_);
    surface->look_again(look_x_, look_v_, seconds_ - elapsed_);
}

void Crawl::rewind() noexcept {
    elapsed_ = 0;
    look_ = 0;
    if (SurfaceGround* surface = surface_ground()) surface->rewind();
    frame_ = {};
    for (Body& body : bodies_) {
        body.frame = {};
        std::fill(body.met.begin(), body.met.end(), 1);
    }
    const auto trace = packed_trace();
    for (std::size_t i = 0; i < trace.size(); ++i) system_->packing().pack(start_trace_[i], trace[i]);
    begin_stretch(0);
    system_->begin_rest_path(start_x_, start_v_);
}

std::array<std::span<double>, 4> Crawl::packed_trace() noexcept {
    return {system_->hook_forces(), turned_, start_x_, start_v_};
}

void Crawl::begin_stretch(std::size_t number) noexcept {
    stretch_ = number;
    for_each_body([&](std::uint32_t body) {
        const auto share = [&](std::size_t at) {
            return static_cast<double>(at) / static_cast<double>(stretches_);
        };
        find_lengths(body, mass_spring::PathEnd::begin, share(number));
        find_lengths(body, mass_spring::PathEnd::end, share(number + 1));
    });
}

void Crawl::find_lengths(std::uint32_t number, mass_spring::PathEnd end, double share) noexcept {
    const Drive& drive = drives_[number];
    Body& body = bodies_[number];
    waves_.flex(std::lerp(drive.cycles[0], drive.cycles[1], share),
                between(drive.effort[0], drive.effort[1], share), body.flexes);
    body.muscles.lengths(body.flexes, body.rest);
    const std::size_t first = lattice_.ring_spring(number, 0);
    const double ease = std::lerp(drive.ease[0], drive.ease[1], share);
    if (ease < 1 && !laid_.empty())
        for (std::size_t i = 0; i < body.rest.size(); ++i)
            body.rest[i] = std::lerp(laid_[first + i], body.rest[i], ease);
    for (std::size_t i = 0; i < body.rest.size(); ++i) system_->set_rest_path(first + i, end, body.rest[i]);
}

// Springs get the lengths of the step's end.
void Crawl::before_step(std::span<const double> x, std::span<const double> v, double h) noexcept {
    start_x_.assign(x.begin(), x.end());
    start_v_.assign(v.begin(), v.end());
    const double middle = (elapsed_ + h / 2) / seconds_ * static_cast<double>(looks_);
    if (const auto now = std::min(static_cast<std::size_t>(middle), looks_ - 1); now != look_) {
        look_ = now;
        look_again(x, v);
    }
    const double at = std::min(1.0, (elapsed_ + h) / seconds_) * static_cast<double>(stretches_);
    const auto stretch = std::min(static_cast<std::size_t>(at), stretches_ - 1);
    if (stretch != stretch_) begin_stretch(stretch);
    const mass_spring::DriveWork done = system_->drive(x, v, at - static_cast<double>(stretch), method_->lag);
    frame_.muscles += done.work;
    frame_.damping += done.damping;
}

void Crawl::after_step(std::span<double> x, std::span<double> v, double h) noexcept {
    elapsed_ += h;
    if (system_->drag() > 0) {
        double work = 0;  // over the way of the step, per drag
        for (std::size_t i = 0; i < x.size(); ++i) work += start_v_[i] * (x[i] - start_x_[i]);
        frame_.damping += system_->drag() * work;
    }
    with_ground(
        [&](const auto& ground) { for_each_body([&](std::uint32_t body) { meet(ground, body, x, v, h); }); });
}

/// m/s^2, that it takes to tear a ring off: nothing where muscles hump it.
double Crawl::holds(std::size_t ring, const Body& body) const noexcept {
    if (!(friction_.adhesion > 0)) return 0;
    const double bent =
        body.flexes[ring > 0 ? ring - 1 : 0].up + body.flexes[std::min(ring, body.flexes.size() - 1)].up;
    return bent < 0 ? 0 : friction_.adhesion;
}

template <class AnyGround>
void Crawl::meet(const AnyGround& ground, std::uint32_t number, std::span<double> x, std::span<double> v,
                 double h) noexcept {
    Body& body = bodies_[number];
    const std::size_t plane = system_->packing().plane(), first = lattice_.point(number, 0);
    for (std::uint32_t ring = 0; ring < lattice_.rings(); ++ring) {
        const Vec3Lanes at = mass_spring::load(x.data() + first + std::size_t{kCorners} * ring, plane);
        body.middles[ring] = 0.25 * Vec3{sum(at.x), sum(at.y), sum(at.z)};
    }
    const double near = kNear * build_.width, reach = kReach * build_.width, mass = build_.point_mass();
    const double lag = std::max(method_->lag, 0.0);
    const Vec3 weighed = h * system_->gravity();
    double* const reactions = system_->hook_forces().data();
    LandingBooks books;
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE {
        const auto meet_two = [&](std::size_t one, std::size_t other, std::size_t corner,
                                  std::uint8_t& met) ORBWEAVER_ALWAYS_INLINE {
            const Four four{plane, first + kCorners * one + corner, first + kCorners * other + corner};
            const Vec3Lanes place = four.get_vectors(x.data());
            const Touches touch = touch_all(ground, place, four);
            if (met == 0 && !is_any(touch.depth > in_all(-reach))) return;
            const Vec3Lanes reaction = four.get_vectors(reactions);
            const LaneBits was_pressed = dot(reaction, reaction) > Lanes{};
            const double hold_one = holds(one, body), hold_other = holds(other, body);
            const Lanes hold{hold_one, hold_one, hold_other, hold_other};
            const LaneBits is_near = touch.depth > (hold > Lanes{} ? in_all(-reach) : in_all(-near));
            const LaneBits are_on = is_near & (was_pressed | (hold > Lanes{}) | (touch.depth > Lanes{}));
            const Vec3 spine = spine_at(body.middles, one), next = spine_at(body.middles, other);
            Landing points{};
            points.x = place;
            points.v = four.get_vectors(v.data());
            points.start = four.get_vectors(start_x_.data());
            points.start_v = four.get_vectors(start_v_.data());
            points.pressed = reaction * in_all(h / mass);
            points.turned = four.get_vectors(turned_.data());
            points.spine = Vec3Lanes{{spine.x, spine.x, next.x, next.x},
                                     {spine.y, spine.y, next.y, next.y},
                                     {spine.z, spine.z, next.z, next.z}};
            points.holds = h * hold;
            points.allowance = near;
            points.weighed = weighed;
            points.lag = lag;
            points.velocity_lag = method_->velocity_lag;
            points.are_damped = build_.damping > 0;
            LandingBooks here;
            meet_ground(touch, are_on, friction_, h, points, here);
            books.add(here, one != other);
            four.put_vectors(points.x, x.data());
            four.put_vectors(points.v, v.data());
            four.put_vectors(points.turned, turned_.data());
            four.put_vectors(points.pressed * in_all(mass / h), reactions);
            met = is_any(are_on) ? 1 : 0;
        };
        const std::size_t rings = body.middles.size();
        auto met = body.met.begin();
        for (std::size_t corner = 0; corner < kCorners; corner += 2)
            for (std::size_t ring = 0; ring < rings; ring += 2)
                meet_two(ring, std::min(ring + 1, rings - 1), corner, *met++);
    });
    body.frame.friction += mass * sum(books.friction);
    body.frame.impact += mass * sum(books.impact);
    body.frame.lift += mass * sum(books.lift);
    body.frame.damping += mass * sum(books.damping);
    body.frame.slip += sum(books.slip);
    body.frame.contact += h * sum(books.contacts);
    body.frame.lagging += mass * sum(books.lagging);
}

double Crawl::work() const noexcept {
    double sum = frame_.muscles;
    for (const Body& body : bodies_) sum -= body.frame.friction + body.frame.impact + body.frame.lagging;
    return sum;
}

double Crawl::other_loss() const noexcept {
    double sum = frame_.damping;
    for (const Body& body : bodies_) sum += body.frame.damping - body.frame.lagging;
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
    const auto trace = packed_trace();
    for (std::size_t i = 0; i < trace.size(); ++i) system_->packing().unpack(trace[i], trace_[i]);
}

std::size_t Crawl::memory_bytes() const noexcept {
    std::size_t bytes =
        drives_.capacity() * sizeof(Drive) + start_trace_.size() * lattice_.points() * sizeof(Vec3) +
        (look_x_.capacity() + look_v_.capacity()) * sizeof(Vec3) +
        (start_x_.capacity() + start_v_.capacity() + turned_.capacity() + laid_.capacity()) * sizeof(double);
    for (const Body& body : bodies_)
        bytes += sizeof(Body) + body.flexes.capacity() * sizeof(Flex) +
                 (body.rest.capacity() + lattice_.rings()) * sizeof(double) +
                 body.middles.capacity() * sizeof(Vec3) + body.met.capacity();
    if (const auto* surface = std::get_if<SurfaceGround>(&ground_)) bytes += surface->memory_bytes();
    return bytes;
}

}  // namespace orbweaver::crawler
