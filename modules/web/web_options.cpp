#include "web_options.hpp"

#include <array>
#include <numbers>
#include <string>

#include "network_file.hpp"
#include "site.hpp"

namespace orbweaver::web {

namespace {

constexpr double kFormFoundDamping = 1e-6;  // N s/m: a few percent of critical for the stiffest modes

StrandRule read_rule(const Options& options, const std::string& strand) {
    return {options.number(strand + ".placement"), options.number(strand + ".rest_length"),
            options.number(strand + ".stiffness")};
}

double read_damping(const Options& options, bool form_found) {
    if (options.has("damping")) return options.number("damping");
    return form_found ? kFormFoundDamping : 0;
}

constexpr std::array kSilkKinds = {Kind::anchor, Kind::frame, Kind::radius, Kind::hub, Kind::spiral};
constexpr std::array kMaterialFigures = {"modulus", "density", "diameter", "prestress"};

template <class Visit>
void for_each_material_key(Visit&& visit) {
    for (const Kind kind : kSilkKinds)
        for (const char* figure : kMaterialFigures)
            visit("material." + std::string(kKindNames[static_cast<std::size_t>(kind)]) + "." + figure);
}

bool has_materials(const Options& options) {
    bool any = false;
    for_each_material_key([&](const std::string& key) { any = any || options.has(key); });
    return any;
}

bool check_materials(const Options& options, Diagnostics& faults) {
    const std::size_t before = faults.size();
    for_each_material_key([&](const std::string& key) {
        if (!options.has(key))
            faults.push_back({options.where("silk"), "the web's silk has no " + key,
                              "modulus, density, diameter and prestress of all five kinds of thread",
                              "say it, or take a silk from assets/silks"});
    });
    return faults.size() == before;
}

void check_curve(const Options& options, const std::string& kind, const Silk& silk, Diagnostics& faults) {
    if (law_of(silk, 1).rises()) return;
    const std::string key = "material." + kind + ".";
    faults.push_back({options.where(key + "softening"),
                      "the " + kind + " threads would bear less when stretched more",
                      key + "softening whose square is below three times " + key + "stiffening", ""});
}

/// Points faults that know no place of their own at the option they come from.
void place(Diagnostics& faults, std::size_t first, const Location& where) {
    for (std::size_t i = first; i < faults.size(); ++i)
        if (faults[i].where.file.empty()) faults[i].where = where;
}

std::optional<Web> build_orb(const Options& options, const Vec3& gravity, const RandomStream& irregularity,
                             Diagnostics& faults) {
    std::optional<Vec3> center;
    if (options.has("center")) center = options.vector("center");
    const auto site = survey(options.vectors("anchors"), center, faults);
    if (!site) return std::nullopt;
    const Construction how = read_construction(options);
    const double mass = options.number("particle_mass");
    const bool form_found = options.text("prestress") == "force_density";
    const double damping = read_damping(options, form_found);
    const Silks silks = read_silks(options, faults);
    if (!faults.empty()) return std::nullopt;
    Web web;
    web.layout = construct(*site, how, irregularity);
    web.network = form_found ? find_form(web.layout, silks, mass, damping, gravity)
                             : over_extend(web.layout, how, mass, damping);
    return web;
}

/// What studies vary: the web as built, made stiffer, heavier or more damped as a whole.
void scale(mass_spring::Network& network, const Options& options) {
    for (double& mass : network.mass) mass *= options.number("mass_scale");
    for (mass_spring::Spring& spring : network.springs) {
        spring.stiffness *= options.number("stiffness_scale");
        spring.law.arm *= options.number("stiffness_scale");
        spring.damping *= options.number("damping_scale");
    }
}

/// Extreme lengths, masses or tensions can leave the range of doubles: such a web must not start to move.
bool check_sound(const Web& web, Diagnostics& faults) {
    const auto found = mass_spring::validate(web.network, web.layout.positions);
    if (found.empty()) return true;
    faults.push_back({{},
                      "the web cannot be built: " + found.front().sentence,
                      "",
                      "choose lengths, masses and tensions nearer to those of webs"});
    return false;
}

std::optional<Web> build_strand(const Options& options, Diagnostics& faults) {
    if (!options.has("strand.from") || !options.has("strand.to")) {
        faults.push_back({{}, "the strand has only one end", "strand.from and strand.to", ""});
        return std::nullopt;
    }
    const StrandPlan plan{options.vector("strand.from"), options.vector("strand.to"),
                          options.number("strand.placement"), options.number("strand.extension"),
                          options.number("strand.stiffness")};
    return lay_single_strand(plan, options.number("particle_mass"), read_damping(options, false), faults);
}

}  // namespace

Construction read_construction(const Options& options) {
    Construction how;
    how.outer_frame = read_rule(options, "outer_frame");
    how.inner_frame = read_rule(options, "inner_frame");
    how.spokes = read_rule(options, "spokes");
    how.move_outer = options.number("outer_frame.move");
    how.inward_pull = options.number("inner_frame.pull");
    how.hub_radius = options.number("hub_radius");
    how.spiral_start = options.number("spiral.start");
    how.spiral_end = options.number("spiral.end");
    how.spiral_density = options.integer("spiral.density");
    how.irregularity = options.number("irregularity");
    return how;
}

Silks read_silks(const Options& options, Diagnostics& faults) {
    const auto material = [&](const std::string& name, const char* what) {
        return options.number("material." + name + "." + what);
    };
    const bool measured = has_materials(options);
    if (measured && !check_materials(options, faults)) return {};
    Silks silks{};
    for (const Kind kind : kSilkKinds) {
        const auto i = static_cast<std::size_t>(kind);
        const std::string name(kKindNames[i]);
        silks[i] = {options.number("tension." + name),
                    options.number("axial_stiffness." + name),
                    0,
                    material(name, "softening"),
                    material(name, "stiffening"),
                    material(name, "hysteresis"),
                    material(name, "relaxation_time")};
        check_curve(options, name, silks[i], faults);
        if (!measured) continue;
        const double diameter = material(name, "diameter");
        const double area = std::numbers::pi / 4 * diameter * diameter;
        silks[i].tension = material(name, "prestress") * area;
        silks[i].axial_stiffness = material(name, "modulus") * area;
        silks[i].linear_density = material(name, "density") * area;
    }
    return silks;
}

std::optional<Web> build_web(const Options& options, const Vec3& gravity, const RandomStream& irregularity,
                             Diagnostics& faults) {
    const char* strand = options.has("strand.to") ? "strand.to" : "strand.from";
    std::string asked;
    const char* source = nullptr;
    for (const char* key : {"anchors", "network", strand}) {
        if (!options.has(key)) continue;
        asked += (source != nullptr ? " and " : "") + std::string(key == strand ? "strand" : key);
        source = source == nullptr ? key : source;
    }
    const std::string expected = "exactly one of anchors, species, network and strand";
    const std::size_t first = faults.size();
    if (source == nullptr) {
        faults.push_back({options.where("anchors"), "the web has nothing to be made of", expected, ""});
        return std::nullopt;
    }
    if (asked.find(" and ") != std::string::npos) {
        faults.push_back({options.where(source), "the web has " + asked, expected, "remove all but one"});
        return std::nullopt;
    }
    std::optional<Web> web;
    if (source == strand)
        web = build_strand(options, faults);
    else if (options.has("network"))
        web = read_network(options.text("network"), faults);
    else
        web = build_orb(options, gravity, irregularity, faults);
    place(faults, first, options.where(source));
    const std::size_t built = faults.size();
    if (web) scale(web->network, options);
    if (web && !check_sound(*web, faults)) web.reset();
    place(faults, built, options.where(options.has("network") ? "network" : "particle_mass"));
    return web;
}

}  // namespace orbweaver::web
