#include "writing_study.hpp"

#include <vector>

namespace orbweaver::inscription {

namespace {

/// All but the last, which is removal of another target.
std::vector<WritingWays::Named> named_modes() {
    std::vector<WritingWays::Named> named;
    for (const Mode& mode : modes())
        if (mode.name != "random_gaps") named.push_back({mode.name.data(), mode.meaning.data()});
    return named;
}

WritingWays::Block block_of(const Box& box, const Page& page) {
    const Spot middle{0.5 * (static_cast<double>(box.left) + box.right),
                      0.5 * (static_cast<double>(box.top) + box.bottom)};
    return {page.point(middle), 0.5 * box.width() * page.pixel * page.right,
            0.5 * box.height() * page.pixel * page.up};
}

}  // namespace

std::span<const WritingWays::Named> WritingStudy::ways() const noexcept {
    static const std::vector<Named> kNamed = named_modes();
    return kNamed;
}

bool WritingStudy::weighs_loss(std::size_t way) const noexcept {
    return find_mode(ways()[way].name)->write == write_legibly;
}

WritingWays::Outcome WritingStudy::write(std::size_t way, const Effort& effort) {
    Scribe scribe = scribe_;
    scribe.mode = find_mode(ways()[way].name);
    if (effort.side) scribe.where.side = *effort.side;
    if (effort.loss) scribe.settings.loss = *effort.loss;
    const Inscription written = scribe.write(*draft_);
    const Naturalness& cost = written.naturalness;
    Outcome outcome{written.at_rest.iou,      written.at_rest.ssim,
                    written.at_rest.contrast, written.plain.iou,
                    cost.silk_share,          cost.max_tension_ratio,
                    cost.mean_shift,          cost.spacing_distance,
                    cost.new_slack,           {}};
    for (const Box& box : written.lettering.blocks)
        outcome.blocks.push_back(block_of(box, written.lettering.page));
    return outcome;
}

}  // namespace orbweaver::inscription
