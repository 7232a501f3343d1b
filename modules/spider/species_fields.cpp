#include "species_fields.hpp"

#include <cmath>

#include "gait.hpp"
#include "plan/table_reader.hpp"
#include "scene/units.hpp"

namespace orbweaver::spider {

std::optional<double> read_quantity(const Node& node, const std::string& key, const char* unit, double min,
                                    double max, Diagnostics& faults) {
    std::optional<double> value;
    if (const auto* number = std::get_if<double>(&node.value)) value = *number;
    if (const auto* integer = std::get_if<std::int64_t>(&node.value)) value = static_cast<double>(*integer);
    if (const auto* text = std::get_if<std::string>(&node.value)) {
        const auto quantity = parse_quantity(*text);
        const Unit wanted = *parse_unit(unit);
        if (quantity && !quantity->has_unit) value = quantity->value;
        if (quantity && quantity->has_unit && quantity->unit.same_dimension(wanted))
            value = convert(*quantity, wanted);
    }
    if (value && std::isfinite(*value) && *value >= min && *value <= max) return value;
    faults.push_back({node.where, fmt::format("'{}' is {}", key, show(node)),
                      fmt::format("{:.4g} to {:.4g}{}", min, max,
                                  unit == std::string_view("1") ? "" : std::string(" ") + unit),
                      ""});
    return std::nullopt;
}

void report_missing(const Location& where, const std::string& key, const char* expected, Diagnostics& faults) {
    faults.push_back({where, fmt::format("'{}' is missing", key), expected, ""});
}

namespace {

std::string gait_names() {
    std::string names;
    for (const Gait& gait : gaits()) names += (names.empty() ? "" : ", ") + std::string(gait.name);
    return names;
}

void read_gait(const Node& node, std::string& into, Diagnostics& faults) {
    const auto* name = std::get_if<std::string>(&node.value);
    if (name != nullptr && find_gait(*name) != nullptr)
        into = *name;
    else
        faults.push_back({node.where, fmt::format("'gait' is {}", show(node)), gait_names(), ""});
}

/// Of a creature, sRGB.
void read_shade(TableReader& reader, const char* key, Vec3& into, Diagnostics& faults) {
    const Node* node = reader.take(key);
    std::array<double, 3> shade{};
    if (node != nullptr && read_quantities(*node, key, "1", 0, 1, shade, faults))
        into = {shade[0], shade[1], shade[2]};
}

void read_length(TableReader& reader, const char* key, double& into, Diagnostics& faults) {
    if (const Node* node = reader.take(key))
        into = read_quantity(*node, key, "m", 1e-7, 1, faults).value_or(into);
}

void read_eyes(const Node& node, std::vector<Eye>& into, Diagnostics& faults) {
    const Array* eyes = node.array();
    if (eyes == nullptr) {
        faults.push_back({node.where, fmt::format("'eyes' is {}", show(node)), "an array of eyes", ""});
        return;
    }
    for (const Node& eye : *eyes) {
        std::array<double, 4> at{};
        if (!read_quantities(eye, "eyes", "m", -10, 10, at, faults)) continue;
        if (at[3] > 0)
            into.push_back({{at[0], at[1], at[2]}, at[3]});
        else
            faults.push_back({eye.where, "an eye's radius is not above 0", "[forward, up, right, radius]", ""});
    }
}

}  // namespace

void read_walk(const Node& node, Walk& into, Diagnostics& faults) {
    TableReader reader(node, faults, "a walk");
    if (const Node* gait = reader.take("gait"))
        read_gait(*gait, into.gait, faults);
    else
        report_missing(node.where, "gait", gait_names().c_str(), faults);
    if (const Node* speed = reader.take("speed"))
        into.speed = read_quantity(*speed, "speed", "m/s", 1e-6, 100, faults).value_or(0);
    else
        report_missing(node.where, "speed", "a speed", faults);
    if (const Node* duty = reader.take("duty")) {
        if (read_quantities(*duty, "duty", "1", 0.5, 0.95, into.duty, faults) && into.duty[0] < into.duty[1])
            faults.push_back(
                {duty->where, "'duty' is larger at top speed than at rest", "the larger first", ""});
    } else {
        report_missing(node.where, "duty", "[at rest, at top speed]", faults);
    }
    if (const Node* stride = reader.take("stride")) {
        if (read_quantities(*stride, "stride", "m", 1e-6, 10, into.stride, faults) &&
            into.stride[0] > into.stride[1])
            faults.push_back(
                {stride->where, "'stride' is longer at rest than at top speed", "the shorter first", ""});
    } else {
        report_missing(node.where, "stride", "[at rest, at top speed]", faults);
    }
    reader.finish();
}

void read_coat(const Node& node, Coat& into, Diagnostics& faults) {
    TableReader reader(node, faults, "a coat");
    read_length(reader, "leg", into.leg, faults);
    read_length(reader, "hair", into.hair, faults);
    read_shade(reader, "carapace", into.carapace, faults);
    read_shade(reader, "abdomen", into.abdomen, faults);
    read_shade(reader, "legs", into.legs, faults);
    read_shade(reader, "marks", into.marks, faults);
    read_shade(reader, "chelicerae", into.chelicerae, faults);
    if (const Node* gloss = reader.take("gloss"))
        into.gloss = read_quantity(*gloss, "gloss", "1", 0, 1, faults).value_or(into.gloss);
    if (const Node* eyes = reader.take("eyes")) read_eyes(*eyes, into.eyes, faults);
    reader.finish();
}

}  // namespace orbweaver::spider
