#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace orbweaver {

/// A file that appears under its name only when it is whole: it grows beside its place under a name that
/// nothing had before (".NAME.part0.EXT"), is moved to its own by commit(), and removed if that never comes.
/// Folders above it are made. Every failure throws Fault: limit when the disk, a quota or the process's
/// file size limit is reached, internal otherwise.
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

    const std::string& path() const noexcept { return path_; }
    /// Where it grows, for a process that writes it in our stead.
    const std::string& partial() const noexcept { return partial_; }

private:
    void open_partial();
    [[noreturn]] void fail(const char* doing);

    std::string path_;    ///< as asked, for sentences
    std::string target_;  ///< what it names: a link is written through, not over
    std::string partial_;
    std::FILE* file_ = nullptr;
    int error_ = 0;  ///< of the first failure: what failed once is never completed
};

}  // namespace orbweaver
