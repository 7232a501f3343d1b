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

namespace {

/// With a point or an exponent, so that it does not look like an integer.
std::string number_text(double number) {
    std::string text = fmt::format("{}", number);
    if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
    return text;
}

/// The start of a long text, whole characters of UTF-8.
std::string shortened(const std::string& text) {
    constexpr std::size_t kLongest = 60;
    if (text.size() <= kLongest) return text;
    std::size_t end = kLongest - 3;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

}  // namespace

std::string show(const Node& node) {
    struct Show {
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
        std::string operator()(double v) const { return number_text(v); }
        std::string operator()(const std::string& v) const { return fmt::format("\"{}\"", shortened(v)); }
        std::string operator()(const Array& v) const { return fmt::format("an array of {}", v.size()); }
        std::string operator()(const Table& v) const { return fmt::format("a table of {} keys", v.size()); }
    };
    return std::visit(Show{}, node.value);
}

}  // namespace orbweaver
