#include "alteration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"

namespace orbweaver::web {

namespace {

[[noreturn]] void refuse(const std::string& sentence) {
    throw Fault(FaultKind::invalid, "the web cannot be changed so: " + sentence);
}

double length_of(const Web& web, std::size_t piece) {
    const Piece& thread = web.layout.pieces[piece];
    return distance(web.layout.positions[thread.a], web.layout.positions[thread.b]);
}

class Alteration {
public:
    Alteration(const Web& plain, const WebChange& change)
        : plain_(plain), change_(change), removed_(plain.layout.pieces.size(), 0), web_(plain) {
        web_.layout.pieces.clear();
        web_.network.springs.clear();
        weigh();
        note_removed();
        note_thickened();
    }

    Web make() {
        std::size_t next = 0;
        for (std::size_t i = 0; i < removed_.size(); ++i) {
            if (removed_[i] != 0) {
                weigh_thread(i, -1);
                continue;
            }
            const std::size_t first = next;
            while (next < parts_.size() && parts_[next].segment == i) ++next;
            cut(i, {parts_.data() + first, next - first});
        }
        for (const WebChange::Added& thread : change_.added) add(thread);
        check_held();
        return std::move(web_);
    }

private:
    /// kg/m of each particle's threads, half of their lengths counted.
    void weigh() {
        const std::size_t count = plain_.network.size();
        density_.resize(count);
        for (std::size_t i = 0; i < plain_.layout.pieces.size(); ++i) {
            const Piece& piece = plain_.layout.pieces[i];
            const double half = 0.5 * length_of(plain_, i) * piece.width;
            density_[piece.a] += half;
            density_[piece.b] += half;
        }
        for (std::size_t i = 0; i < count; ++i)
            density_[i] = density_[i] > 0 ? plain_.network.mass[i] / density_[i] : 0;
    }

    void note_removed() {
        for (const std::uint32_t i : change_.removed) {
            if (i >= removed_.size()) refuse(fmt::format("there is no thread {} to be taken", i));
            if (removed_[i]++ != 0) refuse(fmt::format("thread {} is taken twice", i));
        }
    }

    void note_thickened() {
        parts_ = change_.thickened;
        std::stable_sort(parts_.begin(), parts_.end(), [](const auto& one, const auto& other) {
            return std::pair(one.segment, one.from) < std::pair(other.segment, other.from);
        });
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const WebChange::Thickened& part = parts_[i];
            if (part.segment >= removed_.size() || removed_[part.segment] != 0)
                refuse(fmt::format("thread {}, which is to be thicker, is not there", part.segment));
            if (!(0 <= part.from && part.from < part.to && part.to <= 1) || !(part.width > 0) ||
                !std::isfinite(part.width))
                refuse(fmt::format("thread {} is to be {} times as thick from {} to {} of its length",
                                   part.segment, part.width, part.from, part.to));
            if (i > 0 && parts_[i - 1].segment == part.segment && part.from < parts_[i - 1].to)
                refuse(fmt::format("two of the thicker parts of thread {} overlap", part.segment));
        }
    }

    /// Lays thread i from one end to the other, thicker in those parts.
    void cut(std::size_t i, std::span<const WebChange::Thickened> parts) {
        if (parts.empty()) {
            web_.layout.pieces.push_back(plain_.layout.pieces[i]);
            web_.network.springs.push_back(plain_.network.springs[i]);
            return;
        }
        weigh_thread(i, -1);
        double at = 0;
        Index from = plain_.layout.pieces[i].a;
        for (const WebChange::Thickened& part : parts) {
            if (part.from > at) from = lay_part(i, from, at, part.from, 1);
            from = lay_part(i, from, part.from, part.to, part.width);
            at = part.to;
        }
        if (at < 1) lay_part(i, from, at, 1, 1);
    }

    Index lay_part(std::size_t i, Index from, double begin, double end, double width) {
        const Piece& thread = plain_.layout.pieces[i];
        Index to = thread.b;
        if (end < 1) {
            const auto& at = plain_.layout.positions;
            to = add_particle(web_.layout, at[thread.a] + end * (at[thread.b] - at[thread.a]), false);
            web_.network.mass.push_back(0);
            web_.network.fixed.push_back(0);
            density_.push_back(0.5 * (density_[thread.a] + density_[thread.b]));
        }
        lay(from, to, i, (end - begin) * length_of(plain_, i), width);
        return to;
    }

    void add(const WebChange::Added& thread) {
        if (thread.like >= removed_.size())
            refuse(fmt::format("there is no thread {} to be like", thread.like));
        if (thread.a >= plain_.network.size() || thread.b >= plain_.network.size() || thread.a == thread.b)
            refuse(fmt::format("no thread can lead from point {} to point {}", thread.a, thread.b));
        if (!(thread.width > 0) || !std::isfinite(thread.width))
            refuse(fmt::format("a thread cannot be {} times as thick", thread.width));
        const double length = distance(plain_.layout.positions[thread.a], plain_.layout.positions[thread.b]);
        if (!(length > 0)) refuse(fmt::format("points {} and {} are at one place", thread.a, thread.b));
        lay(thread.a, thread.b, thread.like, length, thread.width);
    }

    /// A thread of that length (m), of the silk of thread `like` and as taut, `width` times as thick.
    void lay(Index a, Index b, std::size_t like, double length, double width) {
        const Piece& piece = plain_.layout.pieces[like];
        mass_spring::Spring laid = plain_.network.springs[like];
        laid.a = a;
        laid.b = b;
        if (laid.rest_length > 0) {
            const double strain = length_of(plain_, like) / laid.rest_length - 1;
            const double rest_length = length / (1 + strain / width), shorter = laid.rest_length / rest_length;
            laid.rest_length = rest_length;
            stiffen(laid, width * shorter);  // EA = k r is the silk's
            laid.law.softening *= shorter;
            laid.law.stiffening *= shorter * shorter;
        } else {
            stiffen(laid, length_of(plain_, like) / length);  // T = k l
        }
        web_.network.springs.push_back(laid);
        web_.layout.pieces.push_back({a, b, piece.kind, piece.width * width});
        weigh_silk(a, b, length * piece.width * width, 1);
    }

    static void stiffen(mass_spring::Spring& spring, double times) {
        spring.stiffness *= times;
        spring.damping *= times;
        spring.law.arm *= times;
    }

    void weigh_thread(std::size_t i, double sign) {
        const Piece& piece = plain_.layout.pieces[i];
        weigh_silk(piece.a, piece.b, length_of(plain_, i) * piece.width, sign);
    }

    void weigh_silk(Index a, Index b, double length, double sign) {
        for (const Index end : {a, b}) web_.network.mass[end] += sign * 0.5 * length * density_[end];
    }

    void check_held() const {
        if (mass_spring::count_parts(web_.network) > mass_spring::count_parts(plain_.network))
            refuse("a part of it would come off");
    }

    const Web& plain_;
    const WebChange& change_;
    std::vector<std::uint8_t> removed_;        ///< by thread
    std::vector<WebChange::Thickened> parts_;  ///< by thread, and along it
    std::vector<double> density_;              ///< kg/m, by particle
    Web web_;
};

}  // namespace

Web alter(const Web& plain, const WebChange& change) { return Alteration(plain, change).make(); }

}  // namespace orbweaver::web
