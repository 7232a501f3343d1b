#include "scene/units.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace orbweaver {

namespace {

struct Symbol {
    std::string_view name;
    Unit unit;
};

constexpr double kPi = 3.14159265358979323846;

// powers:                     kg m  s  rad px
constexpr Symbol kSymbols[] = {
    {"1", {{0, 0, 0, 0, 0}, 0, 1}},           {"m", {{0, 1, 0, 0, 0}, 0, 1}},
    {"g", {{1, 0, 0, 0, 0}, -3, 1}},          {"s", {{0, 0, 1, 0, 0}, 0, 1}},
    {"min", {{0, 0, 1, 0, 0}, 0, 60}},        {"h", {{0, 0, 1, 0, 0}, 0, 3600}},
    {"Hz", {{0, 0, -1, 0, 0}, 0, 1}},         {"N", {{1, 1, -2, 0, 0}, 0, 1}},
    {"Pa", {{1, -1, -2, 0, 0}, 0, 1}},        {"J", {{1, 2, -2, 0, 0}, 0, 1}},
    {"W", {{1, 2, -3, 0, 0}, 0, 1}},          {"rad", {{0, 0, 0, 1, 0}, 0, 1}},
    {"deg", {{0, 0, 0, 1, 0}, 0, kPi / 180}}, {"px", {{0, 0, 0, 0, 1}, 0, 1}},
};

struct Prefix {
    std::string_view name;
    int exponent;
};
constexpr Prefix kPrefixes[] = {{"n", -9}, {"u", -6}, {"\xC2\xB5", -6}, {"\xCE\xBC", -6}, {"m", -3},
                                {"c", -2}, {"k", 3},  {"M", 6},         {"G", 9}};

std::optional<Unit> find_symbol(std::string_view name) {
    for (const Symbol& symbol : kSymbols)
        if (symbol.name == name) return symbol.unit;
    for (const Prefix& prefix : kPrefixes) {
        if (!name.starts_with(prefix.name)) continue;
        const std::string_view rest = name.substr(prefix.name.size());
        if (rest == "1" || rest == "min" || rest == "h" || rest == "deg") continue;
        for (const Symbol& symbol : kSymbols) {
            if (symbol.name != rest) continue;
            Unit unit = symbol.unit;
            unit.exponent += prefix.exponent;
            return unit;
        }
    }
    return std::nullopt;
}

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// One factor such as "m", "s^2", "m3".
std::optional<Unit> parse_factor(std::string_view text) {
    if (text == "1") return Unit{};
    std::size_t end = text.size();
    while (end > 0 && (std::isdigit(static_cast<unsigned char>(text[end - 1])) != 0)) --end;
    if (end > 0 && text[end - 1] == '-') --end;
    int power = 1;
    if (end < text.size()) {
        const auto [rest, error] = std::from_chars(text.data() + end, text.data() + text.size(), power);
        if (error != std::errc{} || std::abs(power) > 9) return std::nullopt;
    }
    std::string_view name = text.substr(0, end);
    if (name.ends_with('^') && end < text.size()) name.remove_suffix(1);
    const auto base = find_symbol(name);
    if (!base) return std::nullopt;
    Unit unit;
    for (std::size_t i = 0; i < unit.powers.size(); ++i) unit.powers[i] = base->powers[i] * power;
    unit.exponent = base->exponent * power;
    for (int i = 0; i < std::abs(power); ++i)
        unit.factor = power > 0 ? unit.factor * base->factor : unit.factor / base->factor;
    return unit;
}

Unit multiply(Unit a, const Unit& b, int sign) {
    for (std::size_t i = 0; i < a.powers.size(); ++i) a.powers[i] += sign * b.powers[i];
    a.exponent += sign * b.exponent;
    a.factor = sign > 0 ? a.factor * b.factor : a.factor / b.factor;
    return a;
}

double scale_by_ten(double value, int exponent) {
    double power = 1;  // exact up to 10^22
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent >= 0 ? value * power : value / power;
}

// A decimal number at the front of `text`, which is shortened by it.
std::optional<double> take_number(std::string_view& text) {
    const std::size_t sign = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
    text = trim(text);
    if (text.empty() || text.size() > 64) return std::nullopt;
    Unit unit;
    int sign = 1;
    while (!text.empty()) {
        const auto end = text.find_first_of(" */");
        const auto factor = parse_factor(text.substr(0, end));
        if (!factor) return std::nullopt;
        unit = multiply(unit, *factor, sign);
        if (end == std::string_view::npos) break;
        text = trim(text.substr(end));
        sign = text.starts_with('/') ? -1 : 1;
        if (text.starts_with('/') || text.starts_with('*')) text = trim(text.substr(1));
        if (text.empty()) return std::nullopt;
    }
    return unit;
}

std::optional<Quantity> parse_quantity(std::string_view text) {
    text = trim(text);
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    Quantity quantity;
    quantity.value = *number;
    text = trim(text);
    if (text.starts_with('/')) {
        std::string_view rest = trim(text.substr(1));
        const auto divisor = take_number(rest);
        if (!divisor) return std::nullopt;
        quantity.value /= *divisor;
        text = trim(rest);
    }
    if (text.empty()) return quantity;
    const auto unit = parse_unit(text);
    if (!unit) return std::nullopt;
    quantity.unit = *unit;
    quantity.has_unit = true;
    return quantity;
}

double convert(const Quantity& quantity, const Unit& unit) noexcept {
    const double factor = quantity.unit.factor / unit.factor;
    const double value = factor == 1 ? quantity.value : quantity.value * factor;
    return scale_by_ten(value, quantity.unit.exponent - unit.exponent);
}

}  // namespace orbweaver
