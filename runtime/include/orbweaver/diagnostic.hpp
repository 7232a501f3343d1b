#pragma once

#include <string>
#include <vector>

namespace orbweaver {

/// Where a value was written. `line` and `column` count from 1; 0 means "the file as a whole".
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
};

/// "file:line:column", or as much of it as is known.
std::string to_string(const Location& where);

/// One fault found while reading, planning, loading or attaching; they are collected, so that a user
/// sees all of them at once.
struct Diagnostic {
    Location where;
    std::string what;      ///< the fault, with what was found
    std::string expected;  ///< what would have been right; may be empty
    std::string remedy;    ///< what to do; may be empty
};

/// "file:line:column: what; expected ...; remedy"
std::string to_string(const Diagnostic& fault);

using Diagnostics = std::vector<Diagnostic>;

}  // namespace orbweaver
