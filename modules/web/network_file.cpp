#include "network_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "orbweaver/fault.hpp"

namespace orbweaver::web {

namespace {

using nlohmann::json;

constexpr int kDeepest = 3;  // an object of arrays of arrays
constexpr std::size_t kMostArrays = 4'000'000;
constexpr std::size_t kMostFaults = 10;
constexpr std::array<const char*, 4> kKeys = {"particles", "masses", "fixed", "springs"};
constexpr const char* kForm = "one object with the keys particles, masses, fixed and springs";

/// Collects the first faults and counts the rest.
class FaultList {
public:
    FaultList(std::string file, Diagnostics& faults) : file_(std::move(file)), faults_(faults) {}

    void add(std::string what, std::string expected, std::string remedy = "") {
        if (++count_ <= kMostFaults)
            faults_.push_back({{file_, 0, 0}, std::move(what), std::move(expected), std::move(remedy)});
    }
    bool empty() const noexcept { return count_ == 0; }
    void finish() {
        if (count_ > kMostFaults)
            faults_.push_back({{file_, 0, 0}, fmt::format("and {} faults more", count_ - kMostFaults), "", ""});
    }

private:
    std::string file_;
    Diagnostics& faults_;
    std::size_t count_ = 0;
};

std::string show(const json& value) {
    constexpr std::size_t kLongest = 40;
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_object()) return "an object";
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

/// The text as a tree, refusing nesting and numbers of arrays that no network has before they are built.
std::optional<json> parse(const std::string& text, FaultList& faults) {
    std::size_t arrays = 0;
    const auto watch = [&](int depth, json::parse_event_t event, json&) {
        if (event != json::parse_event_t::array_start && event != json::parse_event_t::object_start)
            return true;
        if (depth >= kDeepest)
            throw Fault(FaultKind::invalid, fmt::format("arrays are nested more than {} deep", kDeepest));
        if (++arrays > kMostArrays)
            throw Fault(FaultKind::limit, fmt::format("the network has more than {} arrays", kMostArrays));
        return true;
    };
    try {
        return json::parse(text, watch);
    } catch (const json::parse_error& error) {
        const std::string before = text.substr(0, error.byte == 0 ? 0 : error.byte - 1);
        const auto lines = std::count(before.begin(), before.end(), '\n');
        const std::size_t line_start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
        faults.add(fmt::format("line {}, column {} is not JSON", lines + 1, before.size() - line_start + 1),
                   kForm);
    } catch (const json::out_of_range&) {
        faults.add("a number is too large for a double", "finite numbers");
    } catch (const Fault& fault) {
        if (fault.kind() == FaultKind::limit) throw;
        faults.add(fault.what(), kForm);
    }
    return std::nullopt;
}

/// Takes a network's parts out of the tree; every element that does not fit is a fault.
class NetworkReader {
public:
    NetworkReader(const json& root, FaultList& faults) : root_(root), faults_(faults) {}

    Web read() {
        read_particles();
        read_masses();
        read_fixed();
        read_springs();
        return std::move(web_);
    }

private:
    const json* array(const char* key, const char* expected = "an array") {
        const auto found = root_.find(key);
        if (found == root_.end()) {
            faults_.add(fmt::format("{} is missing", key), kForm);
            return nullptr;
        }
        if (found->is_array()) return &*found;
        faults_.add(fmt::format("{} is {}", key, show(*found)), expected);
        return nullptr;
    }

    bool are_numbers(const json& row, std::size_t count) {
        return row.is_array() && row.size() == count &&
               std::all_of(row.begin(), row.end(), [](const json& value) { return value.is_number(); });
    }

    void read_particles() {
        const json* rows = array("particles");
        if (rows == nullptr) return;
        if (rows->size() > kMostParticles)
            throw Fault(FaultKind::limit, fmt::format("the network has {} particles; at most {} are taken",
                                                      rows->size(), kMostParticles));
        if (rows->empty()) faults_.add("particles is empty", "at least one [x, y, z]");
        for (std::size_t i = 0; i < rows->size(); ++i) {
            const json& row = (*rows)[i];
            if (are_numbers(row, 3))
                add_particle(web_.layout, {row[0], row[1], row[2]}, false);
            else
                faults_.add(fmt::format("particles[{}] is {}", i, show(row)), "[x, y, z] in m");
        }
    }

    void read_masses() {
        const std::size_t count = web_.layout.positions.size();
        const auto found = root_.find("masses");
        std::vector<double>& mass = web_.network.mass;
        if (found != root_.end() && found->is_number()) {
            mass.assign(count, found->get<double>());
            return;
        }
        const json* values = array("masses", "an array, or one number for all");
        if (values == nullptr) return;
        if (values->size() != count)
            faults_.add(fmt::format("masses has {} elements for {} particles", values->size(), count),
                        "one mass in kg each, or one number for all");
        for (std::size_t i = 0; i < values->size(); ++i) {
            if ((*values)[i].is_number())
                mass.push_back((*values)[i]);
            else
                faults_.add(fmt::format("masses[{}] is {}", i, show((*values)[i])), "a mass in kg");
        }
    }

    /// A particle's index, or nothing and a fault.
    std::optional<Index> index(const json& value, const std::string& where) {
        const std::size_t count = web_.layout.positions.size();
        if (value.is_number_unsigned() && value.get<std::uint64_t>() < count) return value.get<Index>();
        faults_.add(fmt::format("{} names particle {}", where, show(value)),
                    count == 0 ? "particles to name" : fmt::format("an index from 0 to {}", count - 1));
        return std::nullopt;
    }

    void read_fixed() {
        web_.network.fixed.assign(web_.layout.positions.size(), 0);
        const json* values = array("fixed");
        if (values == nullptr) return;
        for (std::size_t i = 0; i < values->size(); ++i)
            if (const auto particle = index((*values)[i], fmt::format("fixed[{}]", i)))
                web_.network.fixed[*particle] = 1;
    }

    void read_springs() {
        const json* rows = array("springs");
        if (rows == nullptr) return;
        for (std::size_t i = 0; i < rows->size(); ++i) {
            const json& row = (*rows)[i];
            const std::string where = fmt::format("springs[{}]", i);
            if (!are_numbers(row, 5)) {
                faults_.add(fmt::format("{} is {}", where, show(row)),
                            "[i, j, rest_length, stiffness, damping]");
                continue;
            }
            const auto a = index(row[0], where);
            const auto b = index(row[1], where);
            if (!a || !b) continue;
            web_.network.springs.push_back({*a, *b, row[2], row[3], row[4]});
            web_.layout.pieces.push_back({*a, *b, Kind::strand});
        }
    }

    const json& root_;
    FaultList& faults_;
    Web web_;
};

void check_keys(const json& root, FaultList& faults) {
    for (const auto& [key, value] : root.items())
        if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
            faults.add(fmt::format("there is no key '{}'", key.substr(0, 40)), kForm);
}

void check_soundness(const Web& web, FaultList& faults) {
    for (const mass_spring::NetworkFault& fault : mass_spring::validate(web.network, web.layout.positions)) {
        const char* element =
            fault.element == mass_spring::NetworkFault::Element::spring ? "springs" : "particles";
        if (fault.element == mass_spring::NetworkFault::Element::network)
            faults.add(fault.sentence, "");
        else
            faults.add(fmt::format("{}[{}]: {}", element, fault.index, fault.sentence), "");
    }
    if (!faults.empty()) return;
    const std::size_t parts = mass_spring::count_parts(web.network);
    if (parts > 1)
        faults.add(fmt::format("the network is in {} parts that no spring joins", parts),
                   "one connected network", "join them, or give each a file and a [[web]] of its own");
}

void find_middle(Layout& layout) {
    const auto count = static_cast<double>(layout.positions.size());
    for (const Vec3& p : layout.positions) layout.center += p / count;
}

}  // namespace

std::optional<Web> parse_network(const std::string& text, const std::string& name, Diagnostics& all_faults) {
    FaultList faults(name, all_faults);
    std::optional<Web> web;
    if (const auto root = parse(text, faults)) {
        if (!root->is_object()) {
            faults.add(fmt::format("the file holds {}", show(*root)), kForm);
        } else {
            check_keys(*root, faults);
            web = NetworkReader(*root, faults).read();
        }
    }
    if (web && faults.empty()) check_soundness(*web, faults);
    faults.finish();
    if (!web || !faults.empty()) return std::nullopt;
    web->layout.fixed = web->network.fixed;
    find_middle(web->layout);
    return web;
}

std::optional<Web> read_network(const std::string& path, Diagnostics& faults) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (!error && size > kLargestNetworkFile)
        throw Fault(FaultKind::limit, fmt::format("{} has {} bytes; network files of at most {} are read", path,
                                                  size, kLargestNetworkFile));
    std::ifstream file(path, std::ios::binary);
    std::string text(error ? 0 : size, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (error || !file) {
        faults.push_back({{path, 0, 0}, "this file cannot be read", "a network in JSON", ""});
        return std::nullopt;
    }
    return parse_network(text, path, faults);
}

}  // namespace orbweaver::web
