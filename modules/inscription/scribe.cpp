#include "scribe.hpp"

#include <algorithm>

#include "dilate.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kMostTension = 1.5;  ///< of the plain web's largest

bool is_spoilt(const Naturalness& cost) { return cost.new_slack > 0 || cost.max_tension_ratio > kMostTension; }

}  // namespace

Inscription Scribe::write(WebDraft& draft) const {
    const WebAtRest& plain = draft.plain();
    const bool legible = mode->write == write_legibly;
    WhereToWrite place = where;
    place.best_place = legible;
    place.most_ink = settings.loss / std::max(settings.width - 1, 1e-3);
    Lettering page = lay_on(plain, target, place);
    const Bitmap dilated = dilate(page.coverage, kDilation);
    Inscription written;
    const WebAtRest* changed = nullptr;
    const auto attempt = [&](const ModeSettings& how) {
        const WebChange change =
            mode->write({plain, page.page, page.coverage, dilated, plain.mesh_width, page.blur, how, random});
        changed = &draft.changed(change);
        written.naturalness = compare(plain, change, *changed);
        written.removed = change.removed.size();
        written.added = change.added.size();
        written.thickened = change.thickened.size();
    };
    attempt(settings);
    if (legible && is_spoilt(written.naturalness)) {
        ModeSettings gentle = settings;
        gentle.take = false;
        attempt(gentle);
    }
    if (judged_on) {
        place.side = *judged_on;
        page = lay_on(plain, target, place);
    }
    written.lettering = std::move(page);
    written.plain = measure_legibility(plain.points, plain.segments, written.lettering);
    written.at_rest = measure_legibility(changed->points, changed->segments, written.lettering);
    return written;
}

}  // namespace orbweaver::inscription
