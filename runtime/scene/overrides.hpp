#pragma once

#include <string>
#include <string_view>

#include "scene/node.hpp"

namespace orbweaver {

/// Whether this is "path.to.key=value", with no key of the path empty.
bool is_assignment(std::string_view text);

/// Puts "path.to.key=value" into a scene: the value is TOML, or a bare word taken as text
/// ("web.method=rk4"). Where a path meets an array of tables, a number picks one ("web.1.drag=0") and
/// otherwise all are meant. Tables on the way are made. Throws Fault(invalid).
void apply_override(Node& scene, const std::string& assignment);

/// Puts a value at a dotted path, as apply_override does; `where` is what diagnostics will call it.
void set_value(Node& scene, const std::string& path, const Node& value);

/// Takes the value at a dotted path out of a scene, in every table of an array on the way; nothing happens
/// where there is none.
void remove_value(Node& scene, std::string_view path);

}  // namespace orbweaver
