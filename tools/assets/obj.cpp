#include "obj.hpp"

#include <fmt/format.h>

#include <iterator>

namespace orbweaver {

std::string obj_text(const mesh::RawMesh& raw) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    for (const Vec3& p : raw.points) fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
    for (std::size_t i = 0; i < raw.polygon_count(); ++i) {
        if (i == 0 || raw.material[i] != raw.material[i - 1])
            fmt::format_to(out, "usemtl {}\n", raw.material_names[raw.material[i]]);
        fmt::format_to(out, "f");
        for (std::uint32_t c = raw.first[i]; c < raw.first[i + 1]; ++c)
            fmt::format_to(out, " {}", raw.corners[c] + 1);
        fmt::format_to(out, "\n");
    }
    return fmt::to_string(text);
}

}  // namespace orbweaver
