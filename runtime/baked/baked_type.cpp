#include "baked/baked_type.hpp"

#include <algorithm>
#include <fstream>

#include "baked/layout.hpp"
#include "orbweaver/baked_file.hpp"

namespace orbweaver {

std::string baked_type(const std::string& path) {
    if (!is_baked_file(path)) return "";
    baked::Header header;
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header)) return "";
    return {header.type.begin(), std::find(header.type.begin(), header.type.end(), '\0')};
}

}  // namespace orbweaver
