#include "text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

struct Character {
    char32_t code = 0;
    std::size_t bytes = 0;  ///< 0: no UTF-8
};

Character front(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return {first, 1};
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || bytes > text.size()) return {};
    char32_t code = first & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3f);
    }
    constexpr char32_t kFirstOfLength[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < kFirstOfLength[bytes] || code > 0x10ffff || surrogate) return {};
    return {code, bytes};
}

struct Range {
    char32_t first, last;
};

/// Unicode's Cc but for the line break, Zl, Zp, and of Cf what leaves no trace in a line: joiners shape
/// letters.
constexpr Range kControls[] = {{0, 0x9},           {0xb, 0x1f},        {0x7f, 0x9f},      {0xad, 0xad},
                               {0x61c, 0x61c},     {0x180e, 0x180e},   {0x200b, 0x200b},  {0x200e, 0x200f},
                               {0x2028, 0x202e},   {0x2060, 0x206f},   {0xfeff, 0xfeff},  {0xfff9, 0xfffb},
                               {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0001, 0xe007f}};

bool is_control(char32_t code) {
    return std::any_of(std::begin(kControls), std::end(kControls),
                       [&](const Range& range) { return code >= range.first && code <= range.last; });
}

[[noreturn]] void refuse(FaultKind kind, const std::string& sentence) {
    throw Fault(kind, "the text " + sentence);
}

void check_characters(const std::string& text) {
    std::size_t count = 0;
    for (std::string_view rest = text; !rest.empty(); ++count) {
        const Character character = front(rest);
        if (character.bytes == 0)
            refuse(FaultKind::invalid,
                   fmt::format("is not UTF-8 from byte {} on; expected UTF-8, so convert it",
                               text.size() - rest.size()));
        if (is_control(character.code))
            refuse(FaultKind::invalid,
                   fmt::format(
                       "has the control character U+{:04X} as its character {}; expected what can be drawn, "
                       "so leave it out",
                       static_cast<std::uint32_t>(character.code), count + 1));
        rest.remove_prefix(character.bytes);
    }
    if (count > kMostCharacters)
        refuse(FaultKind::limit,
               fmt::format("has {} characters; expected at most {}: a web has room for a few words", count,
                           kMostCharacters));
}

}  // namespace

std::vector<std::string> text_lines(const std::string& text) {
    check_characters(text);
    if (text.find_first_not_of(" \n") == std::string::npos)
        refuse(FaultKind::invalid, "is empty; name the words to be inscribed, such as \"SOME PIG\"");
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back().push_back(c);
    }
    return lines;
}

std::string character_name(std::string_view text) {
    const Character character = front(text);
    return fmt::format("'{}' (U+{:04X})", text.substr(0, character.bytes),
                       static_cast<std::uint32_t>(character.code));
}

}  // namespace orbweaver
