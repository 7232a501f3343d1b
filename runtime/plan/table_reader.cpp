#include "plan/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/nearest_name.hpp"

namespace orbweaver {

const Node* TableReader::take(const std::string& key) {
    known_.push_back(key);
    return find(*node_.table(), key);
}

template <class T>
void TableReader::take_as(const std::string& key, T& into, const char* expected) {
    const Node* node = take(key);
    if (node == nullptr) return;
    if (const T* value = std::get_if<T>(&node->value))
        into = *value;
    else
        wrong(*node, key, expected);
}

void TableReader::take(const std::string& key, bool& into) { take_as(key, into, "a boolean"); }
void TableReader::take(const std::string& key, std::int64_t& into) { take_as(key, into, "an integer"); }
void TableReader::take(const std::string& key, std::string& into) { take_as(key, into, "a text"); }

void TableReader::take(const std::string& key, std::vector<std::string>& into) {
    const Node* node = take(key);
    if (node == nullptr) return;
    const Array* array = node->array();
    if (array == nullptr) return wrong(*node, key, "an array of texts");
    for (const Node& element : *array) {
        if (const auto* text = std::get_if<std::string>(&element.value))
            into.push_back(*text);
        else
            wrong(element, key, "a text");
    }
}

bool TableReader::take_number(const std::string& key, double& into) {
    const Node* node = take(key);
    if (node == nullptr) return false;
    if (const auto* number = std::get_if<double>(&node->value))
        into = *number;
    else if (const auto* integer = std::get_if<std::int64_t>(&node->value))
        into = static_cast<double>(*integer);
    else
        wrong(*node, key, "a number");
    return true;
}

void TableReader::wrong(const Node& node, const std::string& key, const std::string& expected) {
    faults_.push_back({node.where, fmt::format("'{}' is {}", key, show(node)), expected, ""});
}

void TableReader::missing(const std::string& key) {
    faults_.push_back({node_.where, fmt::format("'{}' is missing", key), "a text", ""});
}

void TableReader::finish() {
    for (const Member& member : *node_.table())
        if (std::find(known_.begin(), known_.end(), member.key) == known_.end())
            faults_.push_back(
                {member.where, fmt::format("{} has no key '{}'", owner_, member.key), join_names(known_), ""});
}

}  // namespace orbweaver
