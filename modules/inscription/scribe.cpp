#include "scribe.hpp"

#include <algorithm>

#include "dilate.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

Inscription Scribe::write(WebDraft& draft) const {
    const WebAtRest& plain = draft.plain();
    WhereToWrite place = where;
    place.best_place = mode->write == write_legibly;
    place.most_ink = settings.loss / std::max(settings.width - 1, 1e-3);
    Lettering page = lay_on(plain, target, place);
    const WebChange change = mode->write({plain, page.page, page.coverage, dilate(page.coverage, kDilation),
                                          plain.mesh_width, page.blur, settings, random});
    const WebAtRest& changed = draft.changed(change);
    Inscription written;
    written.naturalness = compare(plain, change, changed);
    written.removed = change.removed.size();
    written.added = change.added.size();
    written.thickened = change.thickened.size();
    if (judged_on) {
        place.side = *judged_on;
        page = lay_on(plain, target, place);
    }
    written.lettering = std::move(page);
    written.plain = measure_legibility(plain.points, plain.segments, written.lettering);
    written.at_rest = measure_legibility(changed.points, changed.segments, written.lettering);
    return written;
}

}  // namespace orbweaver::inscription
