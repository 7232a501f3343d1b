#include "scene/node.hpp"

#include <fmt/format.h>

namespace orbweaver {

const Node* find(const Table& table, std::string_view key) noexcept {
    for (const Member& member : table)
        if (member.key == key) return &member.node;
    return nullptr;
}

Node* find(Table& table, std::string_view key) noexcept {
    return const_cast<Node*>(find(std::as_const(table), key));
}

const char* kind_of(const Node& node) noexcept {
    static constexpr const char* names[] = {"a boolean", "an integer", "a number",
                                            "a text",    "an array",   "a table"};
    return names[node.value.index()];
}

std::string show(const Node& node) {
    struct Show {
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
        std::string operator()(double v) const { return fmt::format("{}", v); }
        std::string operator()(const std::string& v) const {
            return v.size() <= 60 ? fmt::format("\"{}\"", v) : fmt::format("\"{}...\"", v.substr(0, 57));
        }
        std::string operator()(const Array& v) const { return fmt::format("an array of {}", v.size()); }
        std::string operator()(const Table& v) const { return fmt::format("a table of {} keys", v.size()); }
    };
    return std::visit(Show{}, node.value);
}

}  // namespace orbweaver
