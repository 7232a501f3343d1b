#include "grips.hpp"

#include <algorithm>
#include <charconv>

namespace orbweaver::surface {

namespace {

void apply(const GripOverride& given, SurfaceGrip& to) noexcept {
    to.friction = given.friction.value_or(to.friction);
    to.climbable = given.climbable.value_or(to.climbable);
}

void skip_spaces(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
}

bool take(std::string_view& text, char c) {
    skip_spaces(text);
    if (!text.starts_with(c)) return false;
    text.remove_prefix(1);
    return true;
}

std::optional<std::uint32_t> take_number(std::string_view& text) {
    skip_spaces(text);
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// Ascending, each polygon once.
std::vector<PolygonRange> merged(std::vector<PolygonRange> ranges) {
    std::sort(ranges.begin(), ranges.end());
    std::size_t kept = 0;
    for (const PolygonRange& range : ranges) {
        PolygonRange& before = ranges[kept];
        if (range.first <= before.second || range.first - before.second == 1)
            before.second = std::max(before.second, range.second);
        else
            ranges[++kept] = range;
    }
    ranges.resize(kept + 1);
    return ranges;
}

}  // namespace

SurfaceGrip GripOverrides::grip(const mesh::SurfaceMesh& mesh, std::uint32_t face) const noexcept {
    const std::uint16_t property = mesh.property[face];
    const mesh::SurfaceProperty& baked = mesh.properties[property];
    SurfaceGrip grip{baked.friction, baked.climbable != 0};
    apply(all, grip);
    if (property < materials.size()) apply(materials[property], grip);
    const std::uint32_t polygon = mesh.polygon[face];
    const auto range = std::partition_point(patched.begin(), patched.end(),
                                            [&](const PatchedRange& each) { return each.last < polygon; });
    if (range != patched.end() && range->first <= polygon) apply(patches[range->patch], grip);
    return grip;
}

std::optional<std::vector<PolygonRange>> parse_polygons(std::string_view text) {
    std::vector<PolygonRange> ranges;
    do {
        const auto first = take_number(text);
        const auto last = first && take(text, '-') ? take_number(text) : first;
        if (!last || *last < *first) return std::nullopt;
        ranges.emplace_back(*first, *last);
    } while (take(text, ','));
    skip_spaces(text);
    if (!text.empty()) return std::nullopt;
    return merged(std::move(ranges));
}

}  // namespace orbweaver::surface
