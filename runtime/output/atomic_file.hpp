#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace orbweaver {

/// A file that appears under its name only when it is whole: written beside it as "<name>.partial", moved
/// to its name by commit(), removed if that never comes. Every failure throws Fault: limit when the disk or
/// a quota is full, internal otherwise.
class AtomicFile {
public:
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(const void* data, std::size_t size);
    void write(std::string_view text) { write(text.data(), text.size()); }
    /// Overwrites bytes at the front, for headers whose content is known last.
    void rewrite_front(std::string_view text);
    void commit();

private:
    [[noreturn]] void fail(const char* doing);

    std::string path_;    ///< as asked, for sentences
    std::string target_;  ///< what it names
    std::string partial_;
    std::FILE* file_ = nullptr;
    int error_ = 0;  ///< of the first failure: what failed once is never completed
};

/// Makes a folder and its parents. Throws Fault(internal) with a sentence.
void make_directory(const std::string& path, const char* purpose);

}  // namespace orbweaver
