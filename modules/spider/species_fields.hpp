#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "scene/node.hpp"
#include "species.hpp"

namespace orbweaver::spider {

/// Readers of what a species file says. Each reports what is wrong, with its place, to `faults`.

/// A number of `unit` ("1": none), within [min, max]. A fault, and nothing, when it is not.
std::optional<double> read_quantity(const Node& node, const std::string& key, const char* unit, double min,
                                    double max, Diagnostics& faults);

/// As many numbers as `into` has; it stays as it is where there is a fault.
template <std::size_t n>
bool read_quantities(const Node& node, const std::string& key, const char* unit, double min, double max,
                     std::array<double, n>& into, Diagnostics& faults) {
    const Array* array = node.array();
    if (array == nullptr || array->size() != n) {
        faults.push_back(
            {node.where, fmt::format("'{}' is {}", key, show(node)), fmt::format("an array of {}", n), ""});
        return false;
    }
    bool whole = true;
    for (std::size_t i = 0; i < n; ++i) {
        const auto value = read_quantity((*array)[i], key, unit, min, max, faults);
        if (value) into[i] = *value;
        whole = whole && value.has_value();
    }
    return whole;
}

void report_missing(const Location& where, const std::string& key, const char* expected, Diagnostics& faults);

/// [walk]: gait, speed, duty and stride.
void read_walk(const Node& node, Walk& into, Diagnostics& faults);

/// [coat]: what a creature looks like. Whatever is absent stays as it is.
void read_coat(const Node& node, Coat& into, Diagnostics& faults);

}  // namespace orbweaver::spider
