#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "leg_solver.hpp"
#include "orbweaver/fault.hpp"
#include "plan/table_reader.hpp"
#include "rotor.hpp"
#include "scene/toml_reader.hpp"
#include "species.hpp"
#include "species_fields.hpp"

namespace orbweaver::spider {

namespace {

constexpr double kMostTilt = 80 * kDegree;  // at 90 degrees yaw and pitch turn about the same axis

/// What a file says about one joint, rad, and where.
struct JointText {
    std::optional<std::array<double, 2>> limits, comfort;
    std::optional<double> stiffness, rest;
    Location where;
    bool faulty = false;  ///< what is not here may have been said, but wrong
};
using JointTexts = std::array<JointText, kJoints>;

class SpeciesReader {
public:
    explicit SpeciesReader(Diagnostics& faults) : faults_(faults) {}

    Species read(const Node& root, const std::string& name) {
        Species species;
        species.name = name;
        TableReader reader(root, faults_, "a species");
        if (const Node* body = table(reader, "body", root)) read_body(*body, species.body);
        if (const Node* walk = table(reader, "walk", root)) read_walk(*walk, species.walk, faults_);
        JointTexts common;
        if (const Node* joints = table(reader, "joints", root)) read_joints(*joints, common);
        read_legs(reader.take("legs"), root, common, species);
        if (const Node* coat = reader.take("coat")) {
            if (coat->table() != nullptr)
                read_coat(*coat, species.coat, faults_);
            else
                reader.wrong(*coat, "coat", "a table");
        }
        reader.finish();
        return species;
    }

private:
    const Node* table(TableReader& reader, const char* key, const Node& parent) {
        const Node* node = reader.take(key);
        if (node == nullptr) {
            missing(parent.where, key, "a table");
            return nullptr;
        }
        if (node->table() != nullptr) return node;
        reader.wrong(*node, key, "a table");
        return nullptr;
    }

    void missing(const Location& where, const std::string& key, const char* expected) {
        report_missing(where, key, expected, faults_);
    }

    void read_size(TableReader& reader, const Node& table, const char* key, Vec3& into) {
        const Node* node = reader.take(key);
        if (node == nullptr) return missing(table.where, key, "length, height and width");
        std::array<double, 3> size{};
        if (read_quantities(*node, key, "m", 1e-6, 10, size, faults_)) into = {size[0], size[1], size[2]};
    }

    void read_rod(TableReader& reader, const char* key, Rod& into) {
        const Node* node = reader.take(key);
        std::array<double, 2> size{};
        if (node != nullptr && read_quantities(*node, key, "m", 1e-6, 10, size, faults_))
            into = {size[0], size[1]};
    }

    void read_body(const Node& node, Body& body) {
        TableReader reader(node, faults_, "a body");
        read_size(reader, node, "head", body.head);
        read_size(reader, node, "thorax", body.thorax);
        read_size(reader, node, "abdomen", body.abdomen);
        body.waist = 0.25 * std::min(body.thorax.z, body.abdomen.z);
        if (const Node* waist = reader.take("waist"))
            body.waist = read_quantity(*waist, "waist", "m", 1e-6, 10, faults_).value_or(0);
        read_rod(reader, "chelicerae", body.chelicera);
        read_rod(reader, "palps", body.palp);
        if (const Node* bend = reader.take("bend")) {
            std::array<double, 2> range{};
            if (read_quantities(*bend, "bend", "rad", -kPi / 2, kPi / 2, range, faults_)) {
                body.bend_min = range[0];
                body.bend_max = range[1];
                if (!(range[0] <= 0 && 0 <= range[1]))
                    faults_.push_back(
                        {bend->where,
                         fmt::format("'bend' is {:.1f} to {:.1f} deg", degrees(range[0]), degrees(range[1])),
                         "0, a straight back, within it", ""});
            }
        }
        reader.finish();
    }

    void read_joint(const Node& node, double most, JointText& into) {
        TableReader reader(node, faults_, "a joint");
        into.where = node.where;
        const std::size_t faults_before = faults_.size();
        std::array<double, 2> range{};
        if (const Node* limits = reader.take("limits"))
            if (read_quantities(*limits, "limits", "rad", -most, most, range, faults_)) into.limits = range;
        if (const Node* comfort = reader.take("comfort"))
            if (read_quantities(*comfort, "comfort", "rad", -most, most, range, faults_)) into.comfort = range;
        if (const Node* stiffness = reader.take("stiffness"))
            into.stiffness = read_quantity(*stiffness, "stiffness", "1", 0, 1, faults_);
        if (const Node* rest = reader.take("rest"))
            into.rest = read_quantity(*rest, "rest", "rad", -most, most, faults_);
        into.faulty = faults_.size() > faults_before;
        reader.finish();
    }

    void read_joints(const Node& node, JointTexts& into) {
        TableReader reader(node, faults_, "a leg's joints");
        for (std::size_t j = 0; j < kJoints; ++j) {
            const Node* joint = reader.take(kJointNames[j]);
            if (joint == nullptr) continue;
            if (joint->table() != nullptr)
                read_joint(*joint, j == kTilt ? kMostTilt : kPi, into[j]);
            else
                reader.wrong(*joint, kJointNames[j], "a table");
        }
        reader.finish();
    }

    std::array<double, kBones> read_bones(const Node& node) {
        std::array<double, kBones> bones{};
        TableReader reader(node, faults_, "a leg's bones");
        double length = 0;
        bool whole = true;
        for (std::size_t i = 0; i < kBones; ++i) {
            const Node* bone = reader.take(kBoneNames[i]);
            if (bone == nullptr) continue;
            const auto value = read_quantity(*bone, kBoneNames[i], "m", 1e-6, 10, faults_);
            bones[i] = value.value_or(0);
            length += bones[i];
            whole = whole && value.has_value();
        }
        if (whole && length == 0) faults_.push_back({node.where, "the leg has no bones", "at least one", ""});
        reader.finish();
        return bones;
    }

    /// Of the right leg. What the leg itself says comes before what all legs have in common.
    JointRange range_of(std::size_t j, const JointText& common, const JointText& own, const Location& leg) {
        const Location& where = !own.where.file.empty()      ? own.where
                                : !common.where.file.empty() ? common.where
                                                             : leg;
        const auto limits = own.limits ? own.limits : common.limits;
        const auto comfort = own.comfort ? own.comfort : common.comfort;
        const auto rest = own.rest ? own.rest : common.rest;
        if (common.faulty || own.faulty) return {};
        const std::string joint = fmt::format("joints.{}", kJointNames[j]);
        if (!limits) missing(where, joint + ".limits", "[least, most]");
        if (!comfort) missing(where, joint + ".comfort", "[least, most]");
        if (!rest) missing(where, joint + ".rest", "an angle");
        if (!limits || !comfort || !rest) return {};
        const auto& [min, max] = *limits;
        const auto& [comfort_min, comfort_max] = *comfort;
        if (!(min <= comfort_min && comfort_min <= *rest && *rest <= comfort_max && comfort_max <= max))
            faults_.push_back(
                {where,
                 fmt::format("{} has limits {:.1f} to {:.1f} deg, comfort {:.1f} to {:.1f} deg and rest "
                             "{:.1f} deg",
                             joint, degrees(min), degrees(max), degrees(comfort_min), degrees(comfort_max),
                             degrees(*rest)),
                 "rest within comfort, and comfort within limits", ""});
        const double stiffness = own.stiffness.value_or(common.stiffness.value_or(0.5));
        return {min, max, comfort_min, comfort_max, stiffness, *rest};
    }

    static double degrees(double angle) { return angle / kDegree; }

    void read_legs(const Node* node, const Node& root, const JointTexts& common, Species& species) {
        if (node == nullptr) return missing(root.where, "legs", "[[legs]], one for each pair");
        const Array* pairs = node->array();
        if (pairs == nullptr || pairs->empty() || 2 * pairs->size() > kMaxLegs) {
            faults_.push_back({node->where, fmt::format("'legs' is {}", show(*node)),
                               fmt::format("an array of 1 to {} pairs", kMaxLegs / 2), ""});
            return;
        }
        for (const Node& pair : *pairs) {
            if (pair.table() != nullptr)
                read_pair(pair, common, species);
            else
                faults_.push_back({pair.where, fmt::format("'legs' holds {}", show(pair)), "tables", ""});
        }
    }

    void read_pair(const Node& node, const JointTexts& common, Species& species) {
        TableReader reader(node, faults_, "a pair of legs");
        std::array<double, 3> base{};
        double heading = 0;
        if (const Node* at = reader.take("base"))
            read_quantities(*at, "base", "m", -10, 10, base, faults_);
        else
            missing(node.where, "base", "[forward, up, right] of the right leg");
        if (const Node* turned = reader.take("heading"))
            heading = read_quantity(*turned, "heading", "rad", 0, kPi, faults_).value_or(0);
        else
            missing(node.where, "heading", "an angle from forward to the right");
        std::array<double, kBones> bones{};
        if (const Node* lengths = table(reader, "bones", node)) bones = read_bones(*lengths);
        JointTexts own;
        if (const Node* joints = reader.take("joints")) {
            if (joints->table() != nullptr)
                read_joints(*joints, own);
            else
                reader.wrong(*joints, "joints", "a table");
        }
        reader.finish();
        std::array<JointRange, kJoints> ranges{};
        for (std::size_t j = 0; j < kJoints; ++j)
            if (j <= kPitch || bones[j - kPitch] > 0) ranges[j] = range_of(j, common[j], own[j], node.where);
        if (faults_.empty()) add_pair({base[0], base[1], base[2]}, heading, bones, ranges, species);
    }

    /// The left leg is the right one in a mirror, in which turns about y and x change sign.
    static void add_pair(Vec3 base, double heading, const std::array<double, kBones>& bones,
                         std::array<JointRange, kJoints> ranges, Species& species) {
        const std::string number = std::to_string(species.limbs.size() / 2 + 1);
        for (const std::size_t side : {0, 1}) {
            const Rotor<double> turn = rotor(heading);
            Limb limb;
            limb.name = (side == 0 ? "R" : "L") + number;
            limb.base = base;
            limb.axes = {{turn.c, 0, turn.s}, {0, 1, 0}, {-turn.s, 0, turn.c}};
            limb.leg = make_leg(bones, ranges);
            limb.home = to_body(limb, foot_position(limb.leg, rest_pose(limb.leg)));
            species.limbs.push_back(std::move(limb));
            base.z = -base.z;
            heading = -heading;
            for (const std::size_t j : {kYaw, kTilt}) {
                const JointRange r = ranges[j];
                ranges[j] = {-r.max, -r.min, -r.comfort_max, -r.comfort_min, r.stiffness, -r.rest};
            }
        }
    }

    Diagnostics& faults_;
};

/// Legs have to reach the ground below the body, at the height at which it is carried.
void check_stance(const Species& species, const Location& where, Diagnostics& faults) {
    if (!(species.height > 0)) {
        faults.push_back({where,
                          fmt::format("the feet at rest are {:.3g} mm above the thorax's middle, on average",
                                      -1000 * species.height),
                          "feet below it", "turn the legs' joints down at rest, or their bases"});
        return;
    }
    for (const Limb& limb : species.limbs) {
        const Vec3 foot{limb.stance.x, -species.carriage, limb.stance.z};
        LegPose pose = rest_pose(limb.leg);
        const LegResult result =
            find_leg_solver("half_jacobian")->solve(limb.leg, {to_limb(limb, foot)}, {}, pose);
        if (result.answer == LegAnswer::reached) continue;
        faults.push_back({where,
                          fmt::format("leg {} does not reach the ground, {:.3g} mm below the thorax's middle: "
                                      "{:.3g} mm are missing",
                                      limb.name, 1000 * species.carriage, 1000 * result.error),
                          "feet that stand", "give it longer bones or wider limits, or the body less depth"});
    }
}

std::optional<Species> read_species(const Node& root, const std::string& name, Diagnostics& faults) {
    Diagnostics found;
    Species species = SpeciesReader(found).read(root, name);
    faults.insert(faults.end(), found.begin(), found.end());
    if (!found.empty()) return std::nullopt;
    const std::size_t faults_before = faults.size();
    constexpr double kThickness = 0.031;  // of a leg's length
    if (species.coat.leg == 0) species.coat.leg = kThickness * mean_leg_length(species);
    species.shape = shape_of(species.body);
    for (Limb& limb : species.limbs) {
        limb.stance = stance_of(limb);
        species.height -= limb.home.y / static_cast<double>(species.limbs.size());
        species.stance_radius +=
            norm(across(limb.stance, {0, 1, 0})) / static_cast<double>(species.limbs.size());
    }
    constexpr double kClear = 1.15;  // of what hangs below the thorax's middle: who is fat stands taller
    species.carriage = std::max(species.height, kClear * depth_of(species.shape));
    check_stance(species, root.where, faults);
    return faults.size() > faults_before ? std::nullopt : std::optional(species);
}

/// Faults that the reader of TOML throws are whole sentences.
template <class Read>
std::optional<Species> reading(const Read& read, const std::string& name, Diagnostics& faults) {
    try {
        return read_species(read(), name, faults);
    } catch (const Fault& fault) {
        faults.push_back({{}, fault.what(), "", ""});
        return std::nullopt;
    }
}

}  // namespace

std::optional<Species> read_species_file(const std::string& path, Diagnostics& faults) {
    return reading([&] { return read_toml_file(path); }, std::filesystem::path(path).stem().string(), faults);
}

std::optional<Species> read_species_text(const std::string& text, const std::string& name,
                                         Diagnostics& faults) {
    return reading([&] { return read_toml_text(text, name); }, name, faults);
}

}  // namespace orbweaver::spider
