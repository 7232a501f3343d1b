#include "text_lines.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"

using namespace orbweaver;

namespace {

std::string refusal(const std::string& text, FaultKind kind = FaultKind::invalid) {
    try {
        text_lines(text);
    } catch (const Fault& fault) {
        CHECK(fault.kind() == kind);
        return fault.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("lines are parted by line breaks, empty ones are kept", "[unit]") {
    CHECK(text_lines("SOME PIG") == std::vector<std::string>{"SOME PIG"});
    CHECK(text_lines("a\n\nb\n") == std::vector<std::string>{"a", "", "b", ""});
    CHECK(text_lines("\u00e9\u6f22\U0001f437") == std::vector<std::string>{"\u00e9\u6f22\U0001f437"});
}

TEST_CASE("text that cannot be drawn is refused in words", "[unit]") {
    CHECK(refusal("") == "the text is empty; name the words to be inscribed, such as \"SOME PIG\"");
    CHECK(refusal(" \n ") == refusal(""));
    const std::string control = "; expected what can be drawn, so leave it out";
    CHECK(refusal("a\tb") == "the text has the control character U+0009 as its character 2" + control);
    CHECK(refusal("\u00e9\r\n") == "the text has the control character U+000D as its character 2" + control);
    CHECK(refusal("\u0085") == "the text has the control character U+0085 as its character 1" + control);
    CHECK(refusal(std::string("\0", 1)) ==
          "the text has the control character U+0000 as its character 1" + control);
    const std::vector<std::pair<const char*, const char*>> traceless = {
        {"\u00ad", "U+00AD"}, {"\u200b", "U+200B"}, {"\u200f", "U+200F"},
        {"\u2028", "U+2028"}, {"\u2029", "U+2029"}, {"\u202e", "U+202E"},
        {"\u2066", "U+2066"}, {"\ufeff", "U+FEFF"}, {"\U000e0041", "U+E0041"}};
    for (const auto& [character, number] : traceless)
        CHECK(refusal("a" + std::string(character) + "b") ==
              "the text has the control character " + std::string(number) + " as its character 2" + control);
    for (const char* drawn : {"\u00ae", "\u200c", "\u200d", "\u2027", "\u202f", "\ufe0f"})
        CHECK(refusal("a" + std::string(drawn) + "b") == "accepted");
    CHECK(refusal(std::string(1001, 'x'), FaultKind::limit) ==
          "the text has 1001 characters; expected at most 1000: a web has room for a few words");
    CHECK(refusal(std::string(1000, 'x')) == "accepted");
}

// RFC 3629: cut, overlong, surrogates, beyond U+10FFFF, bytes that begin nothing.
TEST_CASE("what is no UTF-8 is refused with the place where it begins", "[unit]") {
    for (const char* bad : {"\x80", "\xc3", "\xc3(", "\xe6\xbc", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                            "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"})
        CHECK(refusal(std::string("ab") + bad) ==
              "the text is not UTF-8 from byte 2 on; expected UTF-8, so convert it");
    for (const char* good :
         {"\xc2\xa1", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"})
        CHECK(refusal(good) == "accepted");
}

TEST_CASE("a character is named by itself and its number", "[unit]") {
    CHECK(character_name("\u00e9a") == "'\u00e9' (U+00E9)");
    CHECK(character_name("\U0001f437") == "'\U0001f437' (U+1F437)");
}
