#pragma once

#include <functional>
#include <optional>
#include <string>

#include "picture/picture.hpp"

namespace orbweaver::study {

/// A reader of letters that is not ours: the program tesseract, where it is installed.
class Reader {
public:
    /// Nothing where PATH has none.
    static std::optional<Reader> find();

    static constexpr const char* kCapitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

    /// What it reads in a picture of dark letters of an alphabet on bright ground, lines parted by '\n'. Throws
    /// Fault(internal) where the program cannot be run, or fails; Fault(stopped), and ends the program, as soon
    /// as `stop_asked` says yes.
    std::string read(const picture::GrayPicture& picture, const std::string& alphabet = kCapitals,
                     const std::function<bool()>& stop_asked = {}) const;

private:
    explicit Reader(std::string program) : program_(std::move(program)) {}
    std::string program_;
};

/// Among what a reader has to choose who does not know the text, but what kinds of characters it has: all
/// capitals, all small letters, all digits, as far as the text has one, and the other characters that it has.
std::string alphabet_of(const std::string& text);

/// The first character that the reader is not sure to know, whose language is English: one beyond ASCII.
std::optional<std::string> unreadable_in(const std::string& text);

/// The letters that have to be put in, taken out and replaced to make what was read of what was written
/// (Levenshtein), characters of UTF-8, over the number of those written; spaces and line ends do not count.
/// Above 1 for what is longer and wrong.
double character_error_rate(const std::string& read, const std::string& written);

}  // namespace orbweaver::study
