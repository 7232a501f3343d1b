#include "output/loaded_libraries.hpp"

#include <link.h>

#include <algorithm>
#include <filesystem>

namespace orbweaver {

std::vector<std::string> loaded_libraries() {
    std::vector<std::string> paths;
    ::dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* list) {
            const std::filesystem::path name = info->dlpi_name != nullptr ? info->dlpi_name : "";
            if (name.has_parent_path())  // neither the program nor what the kernel maps by itself
                static_cast<std::vector<std::string>*>(list)->push_back(
                    std::filesystem::absolute(name).lexically_normal().string());
            return 0;
        },
        &paths);
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace orbweaver
