#include "run/snapshot.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

constexpr char kMagic[8] = {'O', 'R', 'B', 'W', 'S', 'T', 'A', 'T'};

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t byte_order;  // 0x01020304 as the writer stores it
    std::uint64_t checksum;    // XXH3 of everything behind it
    std::uint64_t frame;
    std::uint64_t arrays;
};
constexpr std::uint32_t kVersion1 = 1;
constexpr std::uint32_t kByteOrder = 0x01020304;

void append(std::string& to, const void* data, std::size_t size) {
    to.append(static_cast<const char*>(data), size);
}

void append_word(std::string& to, std::uint64_t word) { append(to, &word, sizeof word); }

/// Reads a snapshot's body front to back; asking for more than is left is a fault.
class Reader {
public:
    Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}
    std::string_view take(std::uint64_t size) {
        if (size > rest_.size())
            throw Fault(FaultKind::invalid,
                        fmt::format("{}: the snapshot ends too early; save it again", name_));
        const std::string_view taken = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return taken;
    }
    std::uint64_t word() {
        std::uint64_t value = 0;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }

private:
    std::string_view rest_;
    const std::string& name_;
};

std::uint64_t checksum(std::string_view snapshot) {
    const std::string_view covered = snapshot.substr(offsetof(Header, frame));
    return XXH3_64bits(covered.data(), covered.size());
}

Header check_header(std::string_view bytes, const std::string& name) {
    Header header{};
    if (bytes.size() < sizeof header || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: this is not a snapshot; expected a file that --save-state wrote", name));
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.version != kVersion1 || header.byte_order != kByteOrder)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: the snapshot has version {} and byte order {:08x}; expected {} and "
                                "{:08x}; save it again with "
                                "this program",
                                name, header.version, header.byte_order, kVersion1, kByteOrder));
    if (checksum(bytes) != header.checksum)
        throw Fault(
            FaultKind::invalid,
            fmt::format("{}: the snapshot is damaged: its checksum does not match; save it again", name));
    return header;
}

}  // namespace

std::string save_snapshot(const Session& session) {
    std::string body;
    Header header{};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    header.version = kVersion1;
    header.byte_order = kByteOrder;
    header.frame = session.frame();
    for (const auto& instance : session.instances())
        for (const StateBlock::Entry& entry : instance->block().entries()) {
            const std::string name = instance->instance_name() + "/" + entry.name;
            append_word(body, name.size());
            append(body, name.data(), name.size());
            append_word(body, entry.bytes());
            append(body, entry.memory(), entry.bytes());
            ++header.arrays;
        }
    std::string bytes;
    append(bytes, &header, sizeof header);
    bytes += body;
    header.checksum = checksum(bytes);
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

void restore_snapshot(Session& session, std::string_view bytes, const std::string& name) {
    const Header header = check_header(bytes, name);
    // Two passes, so that a snapshot that does not fit leaves the session as it was.
    for (const bool copying : {false, true}) {
        Reader reader(bytes.substr(sizeof header), name);
        std::uint64_t arrays = 0;
        for (const auto& instance : session.instances())
            for (StateBlock::Entry& entry : instance->block().entries()) {
                const std::string expected = instance->instance_name() + "/" + entry.name;
                const std::string_view found =
                    ++arrays <= header.arrays ? reader.take(reader.word()) : "(nothing more)";
                const std::uint64_t size = arrays <= header.arrays ? reader.word() : 0;
                if (found != expected || size != entry.bytes())
                    throw Fault(FaultKind::invalid,
                                fmt::format("{}: the snapshot has {} of {} bytes where this scene has {} of "
                                            "{}; restore it into the scene "
                                            "that saved it",
                                            name, found, size, expected, entry.bytes()));
                const std::string_view data = reader.take(size);
                if (copying && size > 0) std::memcpy(entry.memory(), data.data(), size);
            }
        if (arrays != header.arrays)
            throw Fault(
                FaultKind::invalid,
                fmt::format(
                    "{}: the snapshot has {} arrays and this scene {}; restore it into the scene that saved it",
                    name, header.arrays, arrays));
    }
    session.set_frame(header.frame);
    for (const auto& instance : session.instances()) instance->restored();
}

void read_snapshot_file(Session& session, const std::string& path) {
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    std::stringstream bytes;
    bytes << file.rdbuf();
    if (!file || std::filesystem::is_directory(path, error))
        throw Fault(FaultKind::invalid, fmt::format("{}: the snapshot cannot be read; check the path", path));
    restore_snapshot(session, bytes.str(), path);
}

}  // namespace orbweaver
