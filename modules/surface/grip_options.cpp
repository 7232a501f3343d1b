#include "grip_options.hpp"

#include <algorithm>
#include <string>

namespace orbweaver::surface {

namespace {

class GripReader {
public:
    GripReader(const mesh::SurfaceMesh& mesh, Host& host)
        : mesh_(mesh), host_(host), options_(host.options()), last_polygon_(mesh.polygon.back()) {}

    GripOverrides read() {
        grips_.all = given("");
        for (const std::string& name : options_.names_in("material")) read_material(name);
        for (const std::string& name : options_.names_in("patch")) read_patch(name);
        return std::move(grips_);
    }

private:
    GripOverride given(const std::string& prefix) const {
        GripOverride found;
        if (options_.has(prefix + "friction")) found.friction = options_.number(prefix + "friction");
        if (options_.has(prefix + "climbable")) found.climbable = options_.flag(prefix + "climbable");
        return found;
    }

    /// A place in the scene for a fault of what stands behind `prefix`.
    Location where(const std::string& prefix) const {
        for (const char* key : {"polygons", "friction", "climbable"})
            if (options_.given(prefix + key)) return options_.where(prefix + key);
        return options_.where(prefix);
    }

    void read_material(const std::string& name) {
        const std::string prefix = "material." + name + ".";
        grips_.materials.resize(mesh_.properties.size());
        std::string known;
        bool found = false;
        for (std::size_t i = 0; i < mesh_.properties.size(); ++i) {
            const std::string_view each = mesh::material_name(mesh_, i);
            known += (known.empty() ? "'" : ", '") + std::string(each) + "'";
            if (each != name) continue;
            grips_.materials[i] = given(prefix);
            found = true;
        }
        if (!found)
            host_.report_fault(
                {where(prefix), "the mesh has no material '" + name + "'", "one of " + known, ""});
    }

    void read_patch(const std::string& name) {
        const std::string prefix = "patch." + name + ".";
        const std::string patch = "patch '" + name + "'";
        constexpr const char* kList = "a list of polygons such as \"0-11, 15\"";
        if (!options_.has(prefix + "polygons"))
            return host_.report_fault({where(prefix), patch + " names no polygons", kList, ""});
        const std::string& text = options_.text(prefix + "polygons");
        const auto ranges = parse_polygons(text);
        if (!ranges)
            return host_.report_fault({where(prefix), patch + " has the polygons \"" + text + "\"", kList, ""});
        for (const auto& [first, last] : *ranges)
            if (last > last_polygon_)
                return host_.report_fault({where(prefix), patch + " names polygon " + std::to_string(last),
                                           "0 to " + std::to_string(last_polygon_) + ", the mesh's", ""});
        if (!given(prefix).friction && !given(prefix).climbable)
            return host_.report_fault(
                {where(prefix), patch + " says nothing of its polygons", "'friction' or 'climbable'", ""});
        add_patch(name, given(prefix), *ranges);
    }

    void add_patch(const std::string& name, const GripOverride& grip, const std::vector<PolygonRange>& ranges) {
        const auto patch = static_cast<std::uint32_t>(grips_.patches.size());
        grips_.patches.push_back(grip);
        names_.push_back(name);
        auto& all = grips_.patched;
        const auto before = static_cast<std::ptrdiff_t>(all.size());
        for (const auto& [first, last] : ranges) all.push_back({first, last, patch});
        std::inplace_merge(all.begin(), all.begin() + before, all.end(),
                           [](const PatchedRange& a, const PatchedRange& b) { return a.first < b.first; });
        const auto twice =
            std::adjacent_find(all.begin(), all.end(),
                               [](const PatchedRange& a, const PatchedRange& b) { return b.first <= a.last; });
        if (twice == all.end()) return;
        const auto& [one, other] = std::minmax(twice->patch, (twice + 1)->patch);
        host_.report_fault({where("patch." + name + "."),
                            "polygon " + std::to_string((twice + 1)->first) + " is in patch '" + names_[one] +
                                "' and in patch '" + names_[other] + "'",
                            "patches that do not overlap", ""});
        std::erase_if(all, [&](const PatchedRange& each) { return each.patch == patch; });
    }

    const mesh::SurfaceMesh& mesh_;
    Host& host_;
    const Options& options_;
    std::uint32_t last_polygon_;
    GripOverrides grips_;
    std::vector<std::string> names_;  // of the patches
};

}  // namespace

GripOverrides grips_of(const mesh::SurfaceMesh& mesh, Host& host) { return GripReader(mesh, host).read(); }

}  // namespace orbweaver::surface
