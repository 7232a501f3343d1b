#include "scene/toml_reader.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

/// The place behind the string or comment that begins at `at`.
std::size_t skip_text(std::string_view text, std::size_t at) {
    const char quote = text[at];
    if (quote == '#') return std::min(text.find('\n', at), text.size());
    const std::size_t width = text.substr(at, 3) == std::string(3, quote) ? 3 : 1;
    const std::string end(width, quote);
    for (std::size_t i = at + width; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"')
            ++i;
        else if (text.substr(i, width) == end)
            return i + width;
        else if (text[i] == '\n' && width == 1)
            return i;
    }
    return text.size();
}

// The parser and the tree behind it build and free nested tables by recursion: bound them before it runs.
void refuse_deep_keys(std::string_view text, const std::string& name) {
    std::size_t depth = 0;           // tables and arrays that enclose this place
    std::vector<std::size_t> outer;  // the depth outside of each open bracket
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'' || c == '#') {
            const std::size_t end = skip_text(text, i);
            line += static_cast<int>(std::count(text.begin() + i, text.begin() + end, '\n'));
            i = end;
            continue;
        }
        if (c == '[' || c == '{') {
            outer.push_back(depth);
            ++depth;
        } else if ((c == ']' || c == '}') && !outer.empty()) {
            depth = outer.back();
            outer.pop_back();
        } else if (c == '.') {
            ++depth;
        } else if (c == ',' || c == '\n') {
            depth = outer.empty() ? 0 : outer.back() + 1;
            if (c == '\n') ++line;
        }
        if (depth > kMaxKeyDepth)
            throw Fault(FaultKind::limit,
                        fmt::format("{}:{}: a key nests more than {} tables; write a flatter scene", name, line,
                                    kMaxKeyDepth));
        ++i;
    }
}

Location location(const toml::source_region& region, const std::string& name) {
    return {name, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Node convert(const toml::node& from, const std::string& name) {
    Node node;
    node.where = location(from.source(), name);
    if (const auto* table = from.as_table()) {
        Table members;
        for (const auto& [key, value] : *table)
            members.push_back({std::string(key.str()), location(key.source(), name), convert(value, name)});
        // The parser keeps keys by name; a reader of faults wants them as written.
        std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
            return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
        });
        node.value = std::move(members);
    } else if (const auto* array = from.as_array()) {
        Array elements;
        elements.reserve(array->size());
        for (const auto& value : *array) elements.push_back(convert(value, name));
        node.value = std::move(elements);
    } else if (const auto* text = from.as_string()) {
        node.value = text->get();
    } else if (const auto* integer = from.as_integer()) {
        node.value = integer->get();
    } else if (const auto* number = from.as_floating_point()) {
        node.value = number->get();
    } else if (const auto* flag = from.as_boolean()) {
        node.value = flag->get();
    } else {
        throw Fault(FaultKind::invalid, to_string(Diagnostic{node.where, "dates and times mean nothing here",
                                                             "a number, text, "
                                                             "boolean, array or table",
                                                             ""}));
    }
    return node;
}

}  // namespace

Node read_toml_text(std::string_view text, const std::string& name) {
    if (text.size() > kMaxSceneBytes)
        throw Fault(FaultKind::limit,
                    fmt::format("{}: the file has {} bytes and the limit is {}; keep large data in "
                                "files of its own (a network, a mesh) and name them",
                                name, text.size(), kMaxSceneBytes));
    refuse_deep_keys(text, name);
    try {
        return convert(toml::parse(text, name), name);
    } catch (const toml::parse_error& error) {
        throw Fault(FaultKind::invalid, to_string(Diagnostic{location(error.source(), name),
                                                             std::string(error.description()), "TOML", ""}));
    }
}

Node read_toml_file(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: {}; expected a TOML file; check the path", path,
                                std::filesystem::exists(path, error) ? "this is not a regular file"
                                                                     : "there is no such file"));
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Fault(FaultKind::invalid, fmt::format("{}: cannot be opened ({})", path, std::strerror(errno)));
    std::string text(kMaxSceneBytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) throw Fault(FaultKind::invalid, fmt::format("{}: cannot be read", path));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMaxSceneBytes) {
        const auto size = std::filesystem::file_size(path, error);
        throw Fault(FaultKind::limit,
                    fmt::format("{}: the file has {} bytes and the limit is {}; keep large data in "
                                "files of its own (a network, a mesh) and name them",
                                path, size, kMaxSceneBytes));
    }
    return read_toml_text(text, path);
}

}  // namespace orbweaver
