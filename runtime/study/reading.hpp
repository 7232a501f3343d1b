#pragma once

#include <optional>
#include <string>

#include "picture/picture.hpp"

namespace orbweaver::study {

/// A reader of letters that is not ours: the program tesseract, where it is installed.
class Reader {
public:
    /// Nothing where PATH has none.
    static std::optional<Reader> find();

    /// What it reads in a picture of dark capitals on bright ground, lines parted by '\n'. Throws
    /// Fault(internal) where the program cannot be run.
    std::string read(const picture::GrayPicture& picture) const;

private:
    explicit Reader(std::string program) : program_(std::move(program)) {}
    std::string program_;
};

/// The letters that have to be put in, taken out and replaced to make what was read of what was written
/// (Levenshtein), over the number of those written; spaces and line ends do not count. Above 1 for what is
/// longer and wrong.
double character_error_rate(const std::string& read, const std::string& written);

}  // namespace orbweaver::study
