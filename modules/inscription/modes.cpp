#include <algorithm>
#include <array>

#include "mode.hpp"

namespace orbweaver::inscription {

namespace {

constexpr std::array kModes = {
    Mode{"legible", "silk is thickened and added where that serves legibility most", write_legibly},
    Mode{"removal", "the thesis: spiral segments that match the target are taken", remove_matches},
    Mode{"crosshatch", "the thesis: masses are joined to two more along the spiral where that matches",
         crosshatch},
    Mode{"random_attachments", "the thesis: removal, and darker threads at random within the letters",
         attach_at_random},
    Mode{"outline", "the thesis: removal, and denser threads around the letters", strengthen_outline},
    Mode{"random_gaps", "the thesis: removal at random gaps", remove_matches},
};

}  // namespace

std::span<const Mode> modes() noexcept { return kModes; }

const Mode* find_mode(std::string_view name) noexcept {
    const auto found =
        std::find_if(kModes.begin(), kModes.end(), [&](const Mode& mode) { return mode.name == name; });
    return found == kModes.end() ? nullptr : &*found;
}

}  // namespace orbweaver::inscription
