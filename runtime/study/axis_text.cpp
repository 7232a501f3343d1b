#include "study/axis_text.hpp"

#include <cmath>

namespace orbweaver::study {

namespace {

constexpr std::size_t kMostValues = 200;

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Two keys or more, none of them empty.
bool is_path(const std::string& text) {
    return text.find('.') != std::string::npos && ("." + text + ".").find("..") == std::string::npos;
}

/// The parts between commas that stand outside brackets, braces and quotes.
AxisList split(const std::string& text) {
    AxisList parts{""};
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        }
        if (c == ',' && depth == 0 && quote == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    for (std::string& part : parts) part = trimmed(part);
    return parts;
}

bool is_list(const AxisList& parts) {
    for (const std::string& part : parts)
        if (part.empty()) return false;
    return parts.size() >= 2 && parts.size() <= kMostValues;
}

std::optional<AxisRange> parse_range(std::string rest) {
    const auto low = cut(rest, "..");
    const auto high = cut(rest, ":");
    const auto count = cut(rest, ":").value_or(rest);
    const std::string spacing = count == rest ? "" : rest;
    if (!low || !high) return std::nullopt;
    const auto first = parse_quantity(*low);
    const auto last = parse_quantity(*high);
    if (!first || !last || !is_digits(count) || count.size() > 3) return std::nullopt;
    if (!spacing.empty() && spacing != "lin" && spacing != "log") return std::nullopt;
    AxisRange range{*first, *last, std::stoi(count), std::nullopt};
    if (!spacing.empty()) range.log = spacing == "log";
    // One unit behind the upper end is meant for both.
    if (!range.low.has_unit && range.high.has_unit) {
        range.low.unit = range.high.unit;
        range.low.has_unit = true;
    }
    const double begin = convert(range.low, Unit{});
    const double end = convert(range.high, Unit{});
    const bool rises = begin < end && std::isfinite(end - begin) && (begin <= 0 || std::isfinite(end / begin));
    const bool counts = range.count >= 2 && range.count <= static_cast<int>(kMostValues);
    return rises && counts && (range.log != true || begin > 0) ? std::optional(range) : std::nullopt;
}

}  // namespace

std::optional<std::string> cut(std::string& text, std::string_view mark) {
    const auto at = text.find(mark);
    if (at == std::string::npos) return std::nullopt;
    std::string before = text.substr(0, at);
    text.erase(0, at + mark.size());
    return before;
}

bool is_digits(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

std::optional<AxisText> parse_axis(const std::string& text) {
    std::string rest = text;
    const auto path = cut(rest, "=");
    if (!path || !is_path(*path)) return std::nullopt;
    if (AxisList parts = split(rest); parts.size() > 1)
        return is_list(parts) ? std::optional(AxisText{*path, std::move(parts)}) : std::nullopt;
    const auto range = parse_range(rest);
    return range ? std::optional(AxisText{*path, *range}) : std::nullopt;
}

}  // namespace orbweaver::study
