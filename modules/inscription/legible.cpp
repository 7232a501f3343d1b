// Legible writing: which threads are thickened and added is found by an optimisation.
//
// Let u be what a viewer sees: silk per area, blurred by a Gaussian G of one mesh or so. It is linear in how
// much silk x_j is given to each candidate j, u(x) = G (rho + A x), where rho is the plain web's ink and column
// j of A the candidate's. With m = G coverage, the picture sought leaves the web alone beside letters and has a
// tone t within them, u* = (1 - m) G rho + m t: so many times what the web has there on average, or around
// there where that is more, as the thickest threads are thicker. Then x minimises the convex
//
//     1/2 |u(x) - u*|^2 + price * sum_j s_j x_j,   0 <= x_j <= most_j,
//
// s_j the candidate's silk. The price is the least at which the silk that is given stays within the loss
// allowed; so a candidate has silk exactly where that serves the picture more than its price. Candidates are
// parts of spiral threads and radii within letters (most = width - 1: thickened) and threads between
// neighboring radii within letters where there is none (most = width: added). None is taken: a gap is as wide
// as the blur, and letters that clear rings around them are read worse (README). The minimum is found by
// accelerated proximal gradients (Beck and Teboulle 2009) with the diagonal of De Pierro's surrogate, D =
// (GA)^T (GA) 1, for step sizes, restarted where they overshoot (O'Donoghue and Candes 2015).

#include <algorithm>
#include <cmath>
#include <set>

#include "ink.hpp"
#include "line.hpp"
#include "low_pass.hpp"
#include "mode.hpp"
#include "thread_kinds.hpp"
#include "thread_parts.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kBlurPixels = 2;  ///< of the raster that is optimised on, in a standard deviation of the blur
constexpr double kAround = 4;      ///< blurs: how far around is looked for the web's own tone
constexpr double kFinestSide = 1000;  ///< pixels of that raster
constexpr double kLeastPrice = 0.05;  ///< of the tone: less than that is not worth a thread
constexpr int kSteps = 60;            ///< of the descent, from nothing
constexpr int kStepsOn = 20;          ///< from where another price led
constexpr int kHalvings = 7;          ///< of the range of prices
constexpr double kTrifle = 0.15;      ///< threads are not thickened or added by less

/// Something that may be given silk.
struct Candidate {
    enum class Kind { thicken, add } kind;
    std::uint32_t thread;        ///< itself, or of its sort
    Part part;                   ///< of it, that is thickened
    std::uint32_t a = 0, b = 0;  ///< points that an added one joins
    double most;                 ///< of its x
    double silk = 0;             ///< s_j: pixels
};

class Optimisation {
public:
    explicit Optimisation(const Writing& writing)
        : writing_(writing), page_(coarse_page(writing)), blur_(writing.blur / page_.pixel) {
        const Shades plain = ink(writing.web.points, writing.web.segments, page_);
        for (const float each : plain.values) all_silk_ += each;
        seen_ = low_pass(plain, blur_);
        set_goal();
    }

    WebChange run() {
        find_parts();
        find_gaps();
        x_.assign(candidates_.size(), 0);
        if (candidates_.empty() || !(tone_ > 0)) return {};
        set_steps();
        choose_price();
        return rounded();
    }

private:
    static Page coarse_page(const Writing& writing) {
        const double extent = writing.page.pixel * writing.page.side;
        const double side = std::clamp(std::ceil(kBlurPixels * extent / writing.blur), 16.0, kFinestSide);
        return {writing.page.middle, writing.page.right, writing.page.up, extent / side,
                static_cast<std::uint32_t>(side)};
    }

    /// What u(x) - G rho should be.
    void set_goal() {
        Shades coverage(page_.side, page_.side);
        const double shrink = static_cast<double>(page_.side) / writing_.page.side;
        for (std::uint32_t y = 0; y < writing_.page.side; ++y)
            for (std::uint32_t x = 0; x < writing_.page.side; ++x)
                if (writing_.coverage.row(y)[x] != 0)
                    coverage.row(static_cast<std::uint32_t>(
                        (y + 0.5) * shrink))[static_cast<std::uint32_t>((x + 0.5) * shrink)] +=
                        static_cast<float>(shrink * shrink);
        const Shades m = low_pass(coverage, blur_);
        double silk = 0, area = 0;
        for (std::size_t i = 0; i < m.values.size(); ++i) {
            silk += static_cast<double>(m.values[i]) * seen_.values[i];
            area += m.values[i];
        }
        tone_ = area > 0 ? writing_.settings.width * silk / area : 0;
        const Shades around = low_pass(seen_, kAround * blur_);
        const auto times = static_cast<float>(writing_.settings.width);
        goal_ = Shades(page_.side, page_.side);
        for (std::size_t i = 0; i < m.values.size(); ++i)
            goal_.values[i] =
                m.values[i] *
                std::max(std::max(static_cast<float>(tone_), times * around.values[i]) - seen_.values[i], 0.0F);
    }

    Spot spot(std::uint32_t point) const { return page_.spot(writing_.web.points[point]); }

    void add_candidate(Candidate candidate, const Spot& a, const Spot& b, double width) {
        const double length = std::hypot(b.x - a.x, b.y - a.y) * width;
        candidate.silk = length;
        cut_at_pixels(page_.side, page_.side, a, b,
                      [&](std::uint32_t x, std::uint32_t y, double from, double to) {
                          pixels_.push_back({y * page_.side + x, static_cast<float>((to - from) * length)});
                      });
        candidates_.push_back(candidate);
        ends_.push_back(pixels_.size());
    }

    void find_parts() {
        const WebAtRest& web = writing_.web;
        for (const std::string_view kind : {"spiral", "radius"})
            for (const std::uint32_t i : threads_of(web, kind)) {
                const ThreadSegment& thread = web.segments[i];
                const Spot a = spot(thread.a), b = spot(thread.b);
                for (const Part& part : dark_parts(writing_.coverage, writing_.page.spot(web.points[thread.a]),
                                                   writing_.page.spot(web.points[thread.b]), shortest_)) {
                    const auto at = [&](double share) {
                        return Spot{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
                    };
                    add_candidate({Candidate::Kind::thicken, i, part, 0, 0, writing_.settings.width - 1, 0},
                                  at(part.from), at(part.to), thread.width);
                }
            }
    }

    /// Threads between the points of neighboring radii that the spiral leaves bare, from each turn outward to
    /// the next.
    void find_gaps() {
        const WebAtRest& web = writing_.web;
        const std::vector<std::uint32_t> next = next_outward(web);
        std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
        for (const ThreadSegment& thread : web.segments) joined.insert(std::minmax(thread.a, thread.b));
        for (const std::uint32_t i : threads_of(web, "spiral")) {
            std::uint32_t a = web.segments[i].a, b = web.segments[i].b;
            while (next[a] != a && next[b] != b) {
                a = next[a], b = next[b];
                if (!joined.insert(std::minmax(a, b)).second) break;
                if (is_within(a, b))
                    add_candidate({Candidate::Kind::add, i, {}, a, b, writing_.settings.width, 0}, spot(a),
                                  spot(b), web.segments[i].width);
            }
        }
    }

    bool is_within(std::uint32_t a, std::uint32_t b) const {
        const auto parts = dark_parts(writing_.coverage, writing_.page.spot(writing_.web.points[a]),
                                      writing_.page.spot(writing_.web.points[b]), shortest_);
        return parts.size() == 1 && parts[0].from == 0 && parts[0].to == 1;
    }

    /// G A x.
    Shades shown(const std::vector<double>& x) const {
        Shades silk(page_.side, page_.side);
        std::size_t at = 0;
        for (std::size_t j = 0; j < x.size(); ++j)
            for (; at < ends_[j]; ++at)
                silk.values[pixels_[at].index] += static_cast<float>(x[j]) * pixels_[at].silk;
        return low_pass(silk, blur_);
    }

    /// (G A)^T of a picture; G is its own transpose but at the page's edges.
    std::vector<double> pulled(const Shades& picture) const {
        const Shades blurred = low_pass(picture, blur_);
        std::vector<double> out(ends_.size());
        std::size_t at = 0;
        for (std::size_t j = 0; j < out.size(); ++j)
            for (; at < ends_[j]; ++at)
                out[j] += static_cast<double>(blurred.values[pixels_[at].index]) * pixels_[at].silk;
        return out;
    }

    void set_steps() { steps_ = pulled(shown(std::vector<double>(candidates_.size(), 1))); }

    void descend(double price, int count) {
        std::vector<double> ahead = x_;
        double momentum = 1;
        for (int step = 0; step < count; ++step) {
            Shades rest = shown(ahead);
            for (std::size_t i = 0; i < rest.values.size(); ++i) rest.values[i] -= goal_.values[i];
            const std::vector<double> gradient = pulled(rest);
            const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum * momentum));
            double turn = 0;
            for (std::size_t j = 0; j < x_.size(); ++j) {
                const double moved = proximal(j, ahead[j], gradient[j], price), by = moved - x_[j];
                turn += (ahead[j] - moved) * by;
                ahead[j] = moved + (momentum - 1) / next * by;
                x_[j] = moved;
            }
            momentum = next;
            if (turn > 0) {
                ahead = x_;
                momentum = 1;
            }
        }
    }

    double proximal(std::size_t j, double from, double gradient, double price) const {
        if (!(steps_[j] > 0)) return 0;
        const Candidate& candidate = candidates_[j];
        return std::clamp(from - (gradient + price * candidate.silk) / steps_[j], 0.0, candidate.most);
    }

    double loss() const {
        double changed = 0;
        for (std::size_t j = 0; j < x_.size(); ++j) changed += x_[j] * candidates_[j].silk;
        return changed / all_silk_;
    }

    /// At which nothing is worth its silk.
    double dearest_price() const {
        const std::vector<double> gain = pulled(goal_);
        double price = 0;
        for (std::size_t j = 0; j < gain.size(); ++j)
            if (candidates_[j].silk > 0) price = std::max(price, gain[j] / candidates_[j].silk);
        return price;
    }

    void choose_price() {
        double cheap = kLeastPrice * tone_, dear = std::max(dearest_price(), cheap);
        descend(cheap, kSteps);
        if (loss() <= writing_.settings.loss) return;
        std::vector<double> affordable(x_.size(), 0);
        for (int i = 0; i < kHalvings; ++i) {
            const double price = 0.5 * (cheap + dear);
            descend(price, kStepsOn);
            const bool within = loss() <= writing_.settings.loss;
            if (within) affordable = x_;
            (within ? dear : cheap) = price;
        }
        descend(dear, kStepsOn);
        if (loss() > writing_.settings.loss) x_ = affordable;
    }

    WebChange rounded() const {
        WebChange change;
        for (std::size_t j = 0; j < x_.size(); ++j) {
            const Candidate& each = candidates_[j];
            if (x_[j] < kTrifle) continue;
            if (each.kind == Candidate::Kind::add)
                change.added.push_back({each.a, each.b, each.thread, x_[j]});
            else
                change.thickened.push_back({each.thread, each.part.from, each.part.to, 1 + x_[j]});
        }
        return change;
    }

    struct PixelSilk {
        std::uint32_t index;
        float silk;
    };

    const Writing& writing_;
    Page page_;
    double blur_;                                                            // pixels of page_
    double shortest_ = kShortestPart * writing_.mesh / writing_.page.pixel;  // pixels of the writing's page
    Shades seen_;                                                            // G rho
    Shades goal_;                                                            // u* - G rho
    double tone_ = 0;
    double all_silk_ = 0;
    std::vector<Candidate> candidates_;
    std::vector<PixelSilk> pixels_;  // of A, by candidate
    std::vector<std::size_t> ends_;  // where each candidate's pixels end
    std::vector<double> x_, steps_;
};

}  // namespace

WebChange write_legibly(const Writing& writing) { return Optimisation(writing).run(); }

}  // namespace orbweaver::inscription
