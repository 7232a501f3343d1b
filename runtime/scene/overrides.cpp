#include "scene/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "orbweaver/fault.hpp"
#include "scene/toml_reader.hpp"

namespace orbweaver {

namespace {

bool is_index(std::string_view key) {
    return !key.empty() && key.size() < 7 &&
           std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void put(Node& into, std::string_view path, const Node& value) {
    const auto dot = path.find('.');
    const std::string key(path.substr(0, dot));
    const std::string_view rest = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
    if (key.empty() || path.ends_with('.'))
        throw Fault(FaultKind::invalid, fmt::format("{}: the path has an empty key", value.where.file));

    if (Array* array = into.array()) {
        if (!is_index(key)) {
            for (Node& element : *array) put(element, path, value);
            return;
        }
        const std::size_t index = std::stoul(key);
        if (index >= array->size())
            throw Fault(FaultKind::invalid,
                        fmt::format("{}: there is no element {}; expected 0 to {}", value.where.file, index,
                                    array->empty() ? 0 : array->size() - 1));
        if (rest.empty())
            (*array)[index] = value;
        else
            put((*array)[index], rest, value);
        return;
    }
    Table* table = into.table();
    if (table == nullptr)
        throw Fault(FaultKind::invalid, fmt::format("{}: '{}' lies below {}, which is not a table",
                                                    value.where.file, key, show(into)));
    Node* child = find(*table, key);
    if (child == nullptr) {
        table->push_back({key, value.where, Node{Table{}, value.where}});
        child = &table->back().node;
    }
    if (rest.empty())
        *child = value;
    else
        put(*child, rest, value);
}

Node parse_value(const std::string& text, const std::string& name) {
    try {
        Node parsed = read_toml_text("value = " + text, name);
        Table* table = parsed.table();
        if (table != nullptr && table->size() == 1) return std::move(table->front().node);
    } catch (const Fault&) {
        // Not TOML: a bare word, meant as text.
    }
    return Node{text, {}};
}

void relocate(Node& node, const Location& where) {
    node.where = where;
    if (Array* array = node.array())
        for (Node& element : *array) relocate(element, where);
    if (Table* table = node.table())
        for (Member& member : *table) {
            member.where = where;
            relocate(member.node, where);
        }
}

}  // namespace

void set_value(Node& scene, const std::string& path, const Node& value) { put(scene, path, value); }

bool is_assignment(std::string_view text) {
    const std::string path = "." + std::string(text.substr(0, text.find('='))) + ".";
    return text.find('=') != std::string_view::npos && path.find("..") == std::string::npos;
}

void apply_override(Node& scene, const std::string& assignment) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
        throw Fault(FaultKind::invalid, fmt::format("--set {}: expected path.to.key=value", assignment));
    const std::string path = assignment.substr(0, equals);
    if (static_cast<std::size_t>(std::count(path.begin(), path.end(), '.')) > kMaxKeyDepth)
        throw Fault(FaultKind::limit, fmt::format("--set {}...: the path names more than {} tables",
                                                  path.substr(0, 40), kMaxKeyDepth));
    const std::string name = "--set " + path;
    Node value = parse_value(assignment.substr(equals + 1), name);
    relocate(value, {name, 0, 0});
    set_value(scene, path, value);
}

void remove_value(Node& scene, std::string_view path) {
    if (Array* array = scene.array())
        for (Node& element : *array) remove_value(element, path);
    Table* table = scene.table();
    if (table == nullptr) return;
    const auto dot = path.find('.');
    const std::string_view key = path.substr(0, dot);
    if (dot == std::string_view::npos)
        std::erase_if(*table, [&](const Member& member) { return member.key == key; });
    else if (Node* child = find(*table, key))
        remove_value(*child, path.substr(dot + 1));
}

}  // namespace orbweaver
