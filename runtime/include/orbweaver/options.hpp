#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A value after checking: numbers are in the SI unit that the manifest names.
using OptionValue =
    std::variant<bool, std::int64_t, double, std::string, Vec3, std::vector<double>, std::vector<Vec3>>;

/// The options of one module instance, checked against its manifest: every key with a default is
/// present, every value has its declared type, unit and range. Keys of nested tables are dotted
/// ("camera.fov"). Asking for a key or a type that the manifest does not declare is a programming
/// error and throws Fault(internal).
class Options {
public:
    struct Entry {
        OptionValue value;
        Location where;  ///< where the scene says it; empty file when it is the default
    };

    void set(std::string key, OptionValue value, Location where);

    bool has(std::string_view key) const noexcept;
    /// True when the scene itself (or its preset) gave the value.
    bool given(std::string_view key) const noexcept;
    /// Where to point when the value turns out wrong; the table's own place when it is a default.
    Location where(std::string_view key) const;
    void set_table(Location where) { table_ = std::move(where); }

    /// Of options such as "material.*.friction", in the group "material": the names that the scene gives,
    /// sorted.
    std::vector<std::string> names_in(std::string_view group) const;

    bool flag(std::string_view key) const;
    std::int64_t integer(std::string_view key) const;
    double number(std::string_view key) const;
    const std::string& text(std::string_view key) const;
    const Vec3& vector(std::string_view key) const;
    const std::vector<double>& numbers(std::string_view key) const;
    const std::vector<Vec3>& vectors(std::string_view key) const;

    const std::map<std::string, Entry, std::less<>>& entries() const noexcept { return entries_; }

private:
    template <class T>
    const T& get(std::string_view key, const char* type) const;

    std::map<std::string, Entry, std::less<>> entries_;
    Location table_;
};

}  // namespace orbweaver
