#include "study/conditioning.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "orbweaver/random.hpp"

namespace orbweaver::study {

namespace {

/// The n-th of a row of directions, spread evenly over the sphere: points of a cube, outside a ball left out.
Vec3 direction(const RandomStream& stream, std::uint64_t n) {
    constexpr std::uint64_t kTries = 64;  // one in two hits: none in 64 does not happen
    for (std::uint64_t i = kTries * n; i < kTries * (n + 1); ++i) {
        const Vec3 v{stream.uniform(3 * i, -1, 1), stream.uniform(3 * i + 1, -1, 1),
                     stream.uniform(3 * i + 2, -1, 1)};
        if (const double length = norm(v); length <= 1 && length > 0.01) return v / length;
    }
    return {1, 0, 0};
}

}  // namespace

Rung twin_rung(const Subject& subject, const std::function<double(const std::string&)>& longest) {
    const auto& methods = subject.spec().references;
    const auto found = [&](auto&& fits) { return std::find_if(methods.begin(), methods.end(), fits); };
    auto method = found([&](const std::string& name) { return !subject.by_tolerance(name); });
    if (method == methods.end()) method = found([&](const std::string& name) { return subject.by_step(name); });
    if (method != methods.end()) return subject.rung_within(*method, longest(*method));
    return {methods[0], 0, std::max(kDisplacement / 100, subject.least_tolerance())};
}

std::vector<Vec3> free_offsets(const StudySettings& settings, const Subject& subject,
                               const std::vector<std::string>& overrides, double length,
                               const Deadline& deadline) {
    const Trial start = run_trial(settings, subject, {overrides, 0}, deadline);
    const RandomStream stream(subject.scene().seed, "study/displacement");
    std::vector<Vec3> offsets(start.motion.particles);
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = length * direction(stream, i);
    const Trial frame = run_trial(settings, subject, {overrides, start.motion.frame_s, offsets}, deadline);
    if (frame.motion.rows() < 2) return offsets;
    for (std::size_t i = 0; i < offsets.size(); ++i)
        if (frame.motion.row(0)[i] == frame.motion.row(1)[i]) offsets[i] = {};
    return offsets;
}

Conditioning judge(const Motion& motion, const Motion& twin) {
    Conditioning found;
    found.deviation_m = distances(motion, twin);
    const auto parted = std::find_if(found.deviation_m.begin(), found.deviation_m.end(),
                                     [](double d) { return !(d < kUseless); });
    found.whole = parted == found.deviation_m.end();
    found.horizon_rows = std::max<std::size_t>(2, static_cast<std::size_t>(parted - found.deviation_m.begin()));
    for (std::size_t i = 0; i < found.deviation_m.size(); ++i)
        found.time_s.push_back(static_cast<double>(i) * motion.frame_s);
    found.horizon_s = static_cast<double>(found.horizon_rows - 1) * motion.frame_s;
    return found;
}

std::string sentence(const Conditioning& conditioning) {
    const double end = conditioning.deviation_m.empty() ? 0 : conditioning.deviation_m.back();
    const double last = conditioning.time_s.empty() ? 0 : conditioning.time_s.back();
    if (conditioning.whole)
        return fmt::format(
            "conditioning: a displacement of {:g} m is {:.2g} m after {} (by {}); pointwise errors mean "
            "something "
            "over the whole run",
            kDisplacement, end, seconds_text(last), to_string(conditioning.rung));
    return fmt::format(
        "conditioning: a displacement of {:g} m has grown past {:g} m after {} and to {:.2g} m by {} (by {}); "
        "pointwise errors mean something up to there only, and beyond it statistics are compared",
        kDisplacement, kUseless, seconds_text(conditioning.horizon_s), end, seconds_text(last),
        to_string(conditioning.rung));
}

}  // namespace orbweaver::study
