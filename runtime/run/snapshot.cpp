#include "run/snapshot.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

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
    double step;          // s, of a frame
    std::uint64_t setup;  // XXH3 of seed, gravity and all options
};
constexpr std::uint32_t kSnapshotVersion = 2;
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
    if (header.version != kSnapshotVersion || header.byte_order != kByteOrder)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: the snapshot has version {} and byte order {:08x}; expected {} and "
                                "{:08x}; save it again with "
                                "this program",
                                name, header.version, header.byte_order, kSnapshotVersion, kByteOrder));
    if (checksum(bytes) != header.checksum)
        throw Fault(
            FaultKind::invalid,
            fmt::format("{}: the snapshot is damaged: its checksum does not match; save it again", name));
    return header;
}

struct ValueText {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
    std::string operator()(double v) const { return fmt::format("{:a}", v); }
    std::string operator()(const std::string& v) const { return fmt::format("{}:{}", v.size(), v); }
    std::string operator()(const Vec3& v) const { return fmt::format("{:a} {:a} {:a}", v.x, v.y, v.z); }
    template <class T>
    std::string operator()(const std::vector<T>& list) const {
        std::string text;
        for (const T& each : list) text += (*this)(each) + ",";
        return text;
    }
};

/// What a run's future depends on besides its state.
std::uint64_t setup_of(const Session& session) {
    const ValueText text;
    std::string all = fmt::format("{} {}\n", session.scene().seed, text(session.scene().gravity));
    for (const auto& instance : session.instances()) {
        all += instance->instance_name() + "\n";
        for (const auto& [key, entry] : instance->options().entries())
            all += fmt::format("{}={}\n", key, std::visit(text, entry.value));
    }
    return XXH3_64bits(all.data(), all.size());
}

void check_step(const Header& header, const Session& session, const std::string& name) {
    const double step = session.scene().step;
    if (header.step == step) return;
    throw Fault(FaultKind::invalid,
                fmt::format("{}: the snapshot was saved in frames of {} s and this run's are of {} s; run with "
                            "--step {}",
                            name, header.step, step, header.step));
}

}  // namespace

std::string save_snapshot(const Session& session) {
    std::string body;
    Header header{};
    std::memcpy(header.magic, kMagic, sizeof kMagic);
    header.version = kSnapshotVersion;
    header.byte_order = kByteOrder;
    header.frame = session.frame();
    header.step = session.scene().step;
    header.setup = setup_of(session);
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

bool restore_snapshot(Session& session, std::string_view bytes, const std::string& name) {
    const Header header = check_header(bytes, name);
    check_step(header, session, name);
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
    return header.setup == setup_of(session);
}

void read_snapshot_file(Session& session, const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: this is no file; expected a snapshot that --save-state wrote", path));
    std::ifstream file(path, std::ios::binary);
    std::stringstream bytes;
    bytes << file.rdbuf();
    if (!file)
        throw Fault(FaultKind::invalid, fmt::format("{}: the snapshot cannot be read; check the path", path));
    if (!restore_snapshot(session, bytes.str(), path))
        spdlog::warn(
            "{}: the snapshot was saved with another seed or other options; it goes on with those given here",
            path);
}

}  // namespace orbweaver
