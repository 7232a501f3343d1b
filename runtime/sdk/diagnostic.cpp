#include "orbweaver/diagnostic.hpp"

namespace orbweaver {

std::string to_string(const Location& where) {
    std::string text = where.file;
    if (where.line > 0) text += ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
    return text;
}

std::string to_string(const Diagnostic& fault) {
    std::string text = to_string(fault.where);
    if (!text.empty()) text += ": ";
    text += fault.what;
    if (!fault.expected.empty()) text += "; expected " + fault.expected;
    if (!fault.remedy.empty()) text += "; " + fault.remedy;
    return text;
}

}  // namespace orbweaver
