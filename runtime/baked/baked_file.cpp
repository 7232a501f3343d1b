#include "orbweaver/baked_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "baked/layout.hpp"
#include "orbweaver/fault.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace orbweaver {

namespace {

using namespace baked;

constexpr const char* kAgain = "; bake it again with orbweaver-assets";

/// A file's descriptor, closed in the end.
class Descriptor {
public:
    /// Does not wait for whoever writes into a pipe.
    explicit Descriptor(const std::string& path)
        : value_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int value() const noexcept { return value_; }

private:
    int value_;
};

std::span<const std::byte> map(const std::string& path) {
    const auto fail = [&](const char* why) {
        throw Fault(FaultKind::invalid,
                    path + ": cannot be read: " + why + "; name a file that orbweaver-assets baked");
    };
    const Descriptor file(path);
    struct stat status {};
    if (file.value() < 0 || ::fstat(file.value(), &status) != 0) fail(std::strerror(errno));
    if (!S_ISREG(status.st_mode)) fail(S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file");
    if (status.st_size == 0) return {};
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file.value(), 0);
    if (mapped == MAP_FAILED) fail(std::strerror(errno));
    return {static_cast<const std::byte*>(mapped), size};
}

/// Text padded with zeros; what is not printable shows as a question mark.
template <std::size_t N>
std::string text_of(const std::array<char, N>& field) {
    std::string text(field.begin(), std::find(field.begin(), field.end(), '\0'));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return text;
}

std::string versions(std::uint32_t found, std::uint32_t expected) {
    return std::to_string(found) + "; expected " + std::to_string(expected) +
           (found > expected ? ", so update Orbweaver or bake it again with this one's orbweaver-assets"
                             : ", so bake it again with orbweaver-assets");
}

}  // namespace

std::uint64_t baked::checksum(std::span<const std::byte> file) noexcept {
    Header header;
    std::memcpy(&header, file.data(), sizeof header);
    header.checksum = 0;
    XXH3_state_t hash;
    XXH3_64bits_reset(&hash);
    XXH3_64bits_update(&hash, &header, sizeof header);
    XXH3_64bits_update(&hash, file.data() + sizeof header, file.size() - sizeof header);
    return XXH3_64bits_digest(&hash);
}

std::string to_string(const ContentHash& hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint64_t word : {hash.high, hash.low})
        for (int shift = 60; shift >= 0; shift -= 4) text.push_back(kDigits[(word >> shift) & 15]);
    return text;
}

BakedFile::BakedFile(const std::string& path, std::string_view type, std::uint32_t version)
    : path_(path), bytes_(map(path)) {
    try {
        read_header(type, version);
    } catch (...) {
        ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
        throw;
    }
}

BakedFile::BakedFile(BakedFile&& other) noexcept
    : path_(std::move(other.path_)),
      bytes_(std::exchange(other.bytes_, {})),
      source_hash_(other.source_hash_),
      sections_(std::move(other.sections_)) {}

BakedFile& BakedFile::operator=(BakedFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(bytes_, other.bytes_);
    std::swap(source_hash_, other.source_hash_);
    std::swap(sections_, other.sections_);
    return *this;
}

BakedFile::~BakedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

void BakedFile::read_header(std::string_view type, std::uint32_t version) {
    if (bytes_.size() < kMagic.size() || std::memcmp(bytes_.data(), kMagic.data(), kMagic.size()) != 0)
        refuse("is not a baked file; expected one that orbweaver-assets made");
    Header header;
    if (bytes_.size() < sizeof header)
        refuse("is truncated: it has " + std::to_string(bytes_.size()) + " bytes, less than a header" + kAgain);
    std::memcpy(&header, bytes_.data(), sizeof header);
    if (header.byte_order == __builtin_bswap32(kByteOrder))
        refuse("was baked on a machine of the other byte order; bake it again on this one");
    if (header.byte_order != kByteOrder)
        refuse(std::string("is damaged: its mark of byte order means nothing") + kAgain);
    if (header.container_version != kContainerVersion)
        refuse("is a baked file of version " + versions(header.container_version, kContainerVersion));
    if (const std::string found = text_of(header.type); found != type)
        refuse("holds a " + found + "; expected a " + std::string(type));
    if (header.type_version != version)
        refuse("holds a " + std::string(type) + " of version " + versions(header.type_version, version));
    if (header.file_size != bytes_.size())
        refuse((header.file_size > bytes_.size() ? "is truncated: it has " : "is too long: it has ") +
               std::to_string(bytes_.size()) + " of " + std::to_string(header.file_size) + " bytes" + kAgain);
    if (checksum(bytes_) != header.checksum) refuse(std::string("is damaged: its checksum is wrong") + kAgain);
    source_hash_ = {header.source_hash_high, header.source_hash_low};
    read_sections(header.section_count);
}

// The checksum holds: what is wrong here was written wrong, and is refused all the same.
void BakedFile::read_sections(std::size_t count) {
    if (count > kMostSections || sizeof(Header) + count * sizeof(SectionEntry) > bytes_.size())
        refuse("is unsound: it has no room for " + std::to_string(count) + " sections" + kAgain);
    std::size_t end = sizeof(Header) + count * sizeof(SectionEntry);
    for (std::size_t i = 0; i < count; ++i) {
        SectionEntry entry;
        std::memcpy(&entry, bytes_.data() + sizeof(Header) + i * sizeof entry, sizeof entry);
        const std::string name = text_of(entry.name);
        const auto unsound = [&](const char* why) {
            refuse("is unsound: section '" + name + "' " + why + kAgain);
        };
        if (name.empty() || has(name)) unsound("is there twice, or has no name");
        if (entry.reserved != 0 || entry.stride == 0) unsound("has an entry that means nothing");
        if (entry.offset % kAlignment != 0) unsound("is not aligned to 64 bytes");
        if (entry.offset < end) unsound("overlaps what is before it");
        if (entry.offset > bytes_.size() || entry.count > (bytes_.size() - entry.offset) / entry.stride)
            unsound("reaches beyond the end of the file");
        end = entry.offset + entry.count * entry.stride;
        sections_.push_back({name, entry.offset, entry.count, entry.stride});
    }
    if (end != bytes_.size())
        refuse(std::string("is unsound: something lies behind its last section") + kAgain);
}

bool BakedFile::has(std::string_view name) const noexcept {
    return std::any_of(sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name; });
}

const BakedFile::Section& BakedFile::find(std::string_view name, std::size_t stride) const {
    const auto found =
        std::find_if(sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name; });
    if (found == sections_.end()) refuse("is unsound: section '" + std::string(name) + "' is missing" + kAgain);
    if (found->stride != stride)
        refuse("is unsound: section '" + std::string(name) + "' has records of " +
               std::to_string(found->stride) + " bytes; expected " + std::to_string(stride) + kAgain);
    return *found;
}

void BakedFile::refuse(const std::string& what) const { throw Fault(FaultKind::invalid, path_ + ": " + what); }

bool is_baked_file(const std::string& path) noexcept {
    const Descriptor file(path);
    std::array<char, 8> begin{};
    return file.value() >= 0 && ::read(file.value(), begin.data(), begin.size()) == std::ssize(begin) &&
           begin == kMagic;
}

}  // namespace orbweaver
