#include "font_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "orbweaver/fault.hpp"

namespace orbweaver::inscription {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFolders = "/usr/share/fonts, /usr/local/share/fonts or ~/.local/share/fonts";

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders = {"/usr/share/fonts", "/usr/local/share/fonts"};
    if (const char* home = std::getenv("HOME"); home != nullptr)
        folders.push_back(fs::path(home) / ".local/share/fonts");
    return folders;
}

/// Letters and digits of ASCII alone, in lower case: "DejaVuSans-Bold" and "DejaVu Sans Bold" are one.
std::string bare(const std::string& name) {
    std::string kept;
    for (const char c : name) {
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) kept.push_back(c);
        if (c >= 'A' && c <= 'Z') kept.push_back(static_cast<char>(c - 'A' + 'a'));
    }
    return kept;
}

bool is_font_file(const fs::path& path) {
    const std::string extension = path.extension().string();
    return extension == ".ttf" || extension == ".otf" || extension == ".ttc";
}

std::vector<fs::path> font_files() {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const fs::path& folder : font_folders())
        for (auto at = fs::recursive_directory_iterator(folder, ignored);
             at != fs::recursive_directory_iterator() && !ignored; at.increment(ignored))
            if (is_font_file(at->path())) files.push_back(at->path());
    std::sort(files.begin(), files.end());
    return files;
}

/// What the files of a family may be named, the best first.
std::vector<std::string> names_of(const std::string& family, FontWeight weight) {
    const std::string name = bare(family);
    std::vector<std::string> names = {name, name + "regular", name + "book"};
    if (weight == FontWeight::bold) names.insert(names.begin(), name + "bold");
    return names;
}

}  // namespace

std::string find_font(const std::string& font, FontWeight weight) {
    std::error_code ignored;
    if (fs::is_regular_file(font, ignored)) return font;
    if (font.find('/') != std::string::npos)
        throw Fault(FaultKind::invalid,
                    font + ": there is no such font file; correct the path, or name a family");
    const auto files = font_files();
    for (const std::string& name : names_of(font, weight))
        for (const fs::path& file : files)
            if (bare(file.stem().string()) == name) return file.string();
    const bool is_default = bare(font) == bare(kDefaultFont);
    throw Fault(
        FaultKind::invalid,
        "there is no font '" + font + "' in " + kFolders +
            (is_default ? "; install the package fonts-dejavu-core (tools/setup does), or name a font file"
                        : "; install it, or name a font file or another family, such as DejaVu Sans"));
}

}  // namespace orbweaver::inscription
