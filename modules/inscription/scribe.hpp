#pragma once

#include <optional>

#include "legibility.hpp"
#include "lettering.hpp"
#include "mode.hpp"
#include "naturalness.hpp"

namespace orbweaver::inscription {

/// What was written in a web, at rest.
struct Inscription {
    Lettering lettering;  ///< on which it was measured
    Legibility plain;     ///< of the same place before
    Legibility at_rest;   ///< after
    Naturalness naturalness;
    std::size_t removed = 0, added = 0, thickened = 0;  ///< threads, and parts of them
};

/// Writes a target in webs.
struct Scribe {
    const Mode* mode = nullptr;
    Target target;
    WhereToWrite where;  ///< but for what the mode says of it
    ModeSettings settings;
    RandomStream random;
    /// Pixels of the page on which legibility is measured; absent: of the page on which it is written.
    std::optional<std::uint32_t> judged_on;

    /// Changes the draft, and brings it to rest. Throws as lay_on() and the draft do.
    Inscription write(WebDraft& draft) const;
};

}  // namespace orbweaver::inscription
