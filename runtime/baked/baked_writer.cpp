#include "baked/baked_writer.hpp"

#include <algorithm>
#include <cstring>

#include "baked/layout.hpp"
#include "orbweaver/fault.hpp"
#include "output/atomic_file.hpp"

namespace orbweaver {

namespace {

using namespace baked;

template <std::size_t N>
std::array<char, N> field(std::string_view text) {
    if (text.empty() || text.size() > N)
        throw Fault(FaultKind::internal, "'" + std::string(text) + "' does not fit a name of a baked file");
    std::array<char, N> padded{};
    std::copy(text.begin(), text.end(), padded.begin());
    return padded;
}

}  // namespace

BakedWriter::BakedWriter(std::string_view type, std::uint32_t version, const ContentHash& source)
    : type_(type), version_(version), source_(source) {}

void BakedWriter::write(const std::string& path) const {
    std::size_t end = sizeof(Header) + sections_.size() * sizeof(SectionEntry);
    std::vector<SectionEntry> entries;
    for (const Section& section : sections_) {
        entries.push_back({field<16>(section.name), aligned(end), section.bytes.size() / section.stride,
                           static_cast<std::uint32_t>(section.stride), 0});
        end = aligned(end) + section.bytes.size();
    }
    std::vector<std::byte> file(end);
    Header header;
    header.type = field<8>(type_);
    header.type_version = version_;
    header.section_count = static_cast<std::uint32_t>(entries.size());
    header.file_size = end;
    header.source_hash_high = source_.high;
    header.source_hash_low = source_.low;
    std::memcpy(file.data(), &header, sizeof header);
    const auto table = std::as_bytes(std::span(entries));
    std::copy(table.begin(), table.end(), file.begin() + sizeof header);
    for (std::size_t i = 0; i < entries.size(); ++i)
        std::copy(sections_[i].bytes.begin(), sections_[i].bytes.end(),
                  file.begin() + static_cast<std::ptrdiff_t>(entries[i].offset));
    header.checksum = checksum(file);
    std::memcpy(file.data(), &header, sizeof header);
    AtomicFile out(path);
    out.write(file.data(), file.size());
    out.commit();
}

}  // namespace orbweaver
