#include "study/query_questions.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/random.hpp"

namespace orbweaver::study {

namespace {

Vec3 unit(const Vec3& v) { return v / norm(v); }

/// Any unit vector upright to a unit vector.
Vec3 aside(const Vec3& v) { return unit(cross(v, std::abs(v.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})); }

class QuestionMaker {
public:
    QuestionMaker(const Surface& surface, std::uint64_t seed, std::size_t count)
        : surface_(surface), reference_(surface), count_(count), random_(seed, "study/queries") {
        Vec3 low = surface.vertices()[0], high = low;
        for (const Vec3& v : surface.vertices()) {
            low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
            high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
        }
        middle_ = 0.5 * (low + high);
        height_ = 0.01 * surface.size();
    }

    std::vector<QuestionSet> make() {
        std::vector<QuestionSet> sets = {
            rays("random", "rays at random", [&] { return middle_ + 0.7 * size() * in_box(); }),
            rays("vertices", "rays at vertices", [&] { return surface_.vertices()[any_face()[0]]; }),
            rays("edges", "rays at edges",
                 [&] {
                     const auto& face = any_face();
                     const Vec3 &a = surface_.vertices()[face[0]], &b = surface_.vertices()[face[1]];
                     return a + next() * (b - a);
                 }),
            underfoot(), over_edges()};
        std::erase_if(sets, [](const QuestionSet& set) { return set.questions.empty(); });
        return sets;
    }

private:
    double size() const { return surface_.size(); }
    double next(double low = 0, double high = 1) { return random_.uniform(number_++, low, high); }
    Vec3 in_box() {
        const double x = next(-1, 1), y = next(-1, 1), z = next(-1, 1);
        return {x, y, z};
    }
    std::uint32_t any_number() {
        return static_cast<std::uint32_t>(random_.bits(number_++) % surface_.faces().size());
    }
    const std::array<std::uint32_t, 3>& any_face() { return surface_.faces()[any_number()]; }
    Vec3 corner(std::uint32_t face, std::size_t which) const {
        return surface_.vertices()[surface_.faces()[face][which]];
    }
    Vec3 normal(std::uint32_t face) const {
        return unit(cross(corner(face, 1) - corner(face, 0), corner(face, 2) - corner(face, 0)));
    }

    template <class Target>
    QuestionSet rays(const char* name, const char* meaning, Target&& target) {
        QuestionSet set{name, meaning, {}, {}};
        while (set.questions.size() < count_) {
            const Vec3 origin = middle_ + 1.1 * size() * unit(in_box());
            const Vec3 direction = unit(target() - origin);
            Stance question;
            question.position = origin;
            question.up = -direction;
            question.forward = aside(direction);
            add(set, question, reference_.crossing(question));
        }
        return set;
    }

    static void add(QuestionSet& set, const Stance& question, QueryTruth truth) {
        set.questions.push_back(question);
        set.truths.push_back(std::move(truth));
    }

    /// Walks of a hundred steps, each from another face, turning back at borders.
    QuestionSet underfoot() {
        constexpr int kSteps = 100;
        QuestionSet set{"underfoot", "bodies that walk", {}, {}};
        for (std::size_t walk = 0; set.questions.size() < count_ && walk < count_; ++walk) {
            const std::uint32_t face = any_number();
            Footing at =
                surface_.place({face, {0.4, 0.3, 0.3}}, normal(face), corner(face, 1) - corner(face, 0)).end;
            std::uint32_t last = face;
            for (int i = 0; i < kSteps && set.questions.size() < count_; ++i) {
                const Vec3 steer = next(-0.3, 0.3) * cross(at.up, at.forward);
                const SurfaceStep step =
                    surface_.step(surface_.place(at.at, at.up, at.forward + steer).end, 2e-3 * size());
                if (step.answer != Answer::found) break;
                at = step.end;
                if (step.stop == StepStop::border) at.forward = -at.forward;
                const Stance question{
                    at.position + height_ * at.up, at.up, at.forward, last, at.side, 1.5 * height_};
                last = at.at.face;
                if (QueryTruth truth = reference_.crossing(question); truth.certain)
                    add(set, question, std::move(truth));
            }
        }
        return set;
    }

    QuestionSet over_edges() {
        constexpr std::size_t kTries = 20;
        QuestionSet set{"over_edges", "bodies just beyond an edge", {}, {}};
        for (std::size_t i = 0; i < kTries * count_ && set.questions.size() < count_; ++i) {
            const std::uint32_t face = any_number();
            const std::size_t edge = random_.bits(number_++) % 3;
            const Vec3 along = corner(face, (edge + 1) % 3) - corner(face, edge);
            const Vec3 up = normal(face), out = unit(cross(along, up));
            const Vec3 at = corner(face, edge) + next(0.2, 0.8) * along;
            const Stance question{at + height_ * up + 0.5 * height_ * out, up, out, face, 1, 3 * height_};
            if (reference_.crossing(question).places.empty()) add(set, question, reference_.nearest(question));
        }
        return set;
    }

    const Surface& surface_;
    QueryReference reference_;
    std::size_t count_;
    RandomStream random_;
    std::uint64_t number_ = 0;
    Vec3 middle_;
    double height_;
};

}  // namespace

bool QuestionSet::suits(SurfaceWays::Finds finds) const {
    if (name == "underfoot") return true;
    return (name == "over_edges") != (finds == SurfaceWays::Finds::crossing);
}

std::vector<QuestionSet> make_questions(const Surface& surface, std::uint64_t seed, std::size_t count) {
    return QuestionMaker(surface, seed, count).make();
}

}  // namespace orbweaver::study
