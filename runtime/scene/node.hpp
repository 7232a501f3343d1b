#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "orbweaver/diagnostic.hpp"

namespace orbweaver {

struct Node;

struct Member;
using Table = std::vector<Member>;  ///< in the order written
using Array = std::vector<Node>;

/// A value of a scene, manifest or species file, with the place it was written at.
struct Node {
    std::variant<bool, std::int64_t, double, std::string, Array, Table> value;
    Location where;

    const Table* table() const noexcept { return std::get_if<Table>(&value); }
    Table* table() noexcept { return std::get_if<Table>(&value); }
    const Array* array() const noexcept { return std::get_if<Array>(&value); }
    Array* array() noexcept { return std::get_if<Array>(&value); }
};

struct Member {
    std::string key;
    Location where;  ///< of the key
    Node node;
};

/// The member of that name, or null.
const Node* find(const Table& table, std::string_view key) noexcept;
Node* find(Table& table, std::string_view key) noexcept;

/// "a boolean", "an integer", ...: what a value is, for sentences.
const char* kind_of(const Node& node) noexcept;
/// The value as a scene would write it, shortened to fit a sentence.
std::string show(const Node& node);

}  // namespace orbweaver
