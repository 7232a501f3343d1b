#pragma once

#include <sys/stat.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "support/folder.hpp"

namespace orbweaver::test {

/// A variable of the surroundings with another value, or none, while this lives.
class Surrounded {
public:
    Surrounded(std::string name, const std::optional<std::string>& value) : name_(std::move(name)) {
        if (const char* before = std::getenv(name_.c_str())) before_ = before;
        set(value);
    }
    Surrounded(const Surrounded&) = delete;
    Surrounded& operator=(const Surrounded&) = delete;
    ~Surrounded() { set(before_); }

private:
    void set(const std::optional<std::string>& value) const {
        if (value)
            ::setenv(name_.c_str(), value->c_str(), 1);
        else
            ::unsetenv(name_.c_str());
    }

    std::string name_;
    std::optional<std::string> before_;
};

/// Writes a shell script that may be run, and gives its path.
inline std::string write_script(const Folder& folder, const std::string& name, const std::string& lines) {
    const std::string path = folder.write(name, "#!/bin/sh\n" + lines);
    ::chmod(path.c_str(), 0700);
    return path;
}

/// Stands first in PATH, in place of the program that reads: says 64 letters that depend on every byte of the
/// picture that it is given.
class FakeReader {
    Folder folder_;
    Surrounded path_{"PATH", folder_.path() + ":/usr/bin:/bin"};

public:
    FakeReader() { write_script(folder_, "tesseract", "sha256sum | cut -c 1-64 | tr 0-9a-f A-P\n"); }
};

}  // namespace orbweaver::test
