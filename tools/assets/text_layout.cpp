#include "text_layout.hpp"

#include <fmt/format.h>
#include <hb-ft.h>
#include <hb.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "orbweaver/fault.hpp"
#include "text_lines.hpp"

namespace orbweaver {

namespace {

template <auto Destroy>
struct Release {
    template <class T>
    void operator()(T* object) const noexcept {
        Destroy(object);
    }
};
using Buffer = std::unique_ptr<hb_buffer_t, Release<hb_buffer_destroy>>;
using Face = std::unique_ptr<hb_face_t, Release<hb_face_destroy>>;
using Shaper = std::unique_ptr<hb_font_t, Release<hb_font_destroy>>;

Shaper shaper_of(const Font& font) {
    const Face face(hb_ft_face_create_referenced(font.face()));
    return Shaper(hb_font_create(face.get()));  // its scale is the font's own
}

struct Line {
    std::vector<PlacedGlyph> glyphs;
    double width = 0;
};

/// Shapes lines and remembers what the font lacks.
class Setter {
public:
    explicit Setter(const Font& font) : font_(font), shaper_(shaper_of(font)) {}

    Line set(const std::string& text) {
        const Buffer buffer(hb_buffer_create());
        hb_buffer_set_cluster_level(buffer.get(), HB_BUFFER_CLUSTER_LEVEL_CHARACTERS);
        hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
        hb_buffer_guess_segment_properties(buffer.get());
        hb_shape(shaper_.get(), buffer.get(), nullptr, 0);
        unsigned count = 0;
        const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
        const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer.get(), &count);
        Line line;
        for (unsigned i = 0; i < count; ++i) {
            if (infos[i].codepoint == 0) miss(std::string_view(text).substr(infos[i].cluster));
            line.glyphs.push_back(
                {infos[i].codepoint, line.width + places[i].x_offset, static_cast<double>(places[i].y_offset)});
            line.width += places[i].x_advance;
            if (places[i].x_advance > 0) line.width += static_cast<double>(font_.growth());
        }
        return line;
    }

    double line_height() const {
        hb_font_extents_t extents{};
        hb_font_get_h_extents(shaper_.get(), &extents);
        return extents.ascender - extents.descender + extents.line_gap;
    }

    void check_nothing_missed() const {
        if (missed_.empty()) return;
        throw Fault(FaultKind::invalid,
                    fmt::format("{} has no {}; leave {} out, or name a font that has {}", font_.path(),
                                fmt::join(missed_, ", "), missed_.size() == 1 ? "it" : "them",
                                missed_.size() == 1 ? "it" : "them"));
    }

private:
    void miss(std::string_view character) {
        const std::string name = character_name(character);
        if (std::find(missed_.begin(), missed_.end(), name) == missed_.end()) missed_.push_back(name);
    }

    const Font& font_;
    Shaper shaper_;
    std::vector<std::string> missed_;
};

double share_before(inscription::Align align) {
    switch (align) {
        case inscription::Align::left:
            return 0;
        case inscription::Align::center:
            return 0.5;
        case inscription::Align::right:
            return 1;
    }
    return 0;
}

}  // namespace

std::vector<PlacedGlyph> lay_out(const std::vector<std::string>& lines, const Font& font,
                                 inscription::Align align, double line_spacing) {
    Setter setter(font);
    std::vector<PlacedGlyph> all;
    double y = 0;
    for (const std::string& text : lines) {
        const Line line = setter.set(text);
        for (const PlacedGlyph& each : line.glyphs)
            all.push_back({each.glyph, each.x - share_before(align) * line.width, each.y + y});
        y -= line_spacing * setter.line_height();
    }
    setter.check_nothing_missed();
    return all;
}

}  // namespace orbweaver
