#include "raw_mesh_bytes.hpp"

#include <cstring>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

template <class T>
void put(std::string& bytes, const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

class Reader {
public:
    Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    template <class T>
    void take(std::vector<T>& values) {
        const auto count = take_one<std::uint64_t>();
        if (count > rest_.size() / sizeof(T)) refuse();
        values.resize(count);
        if (count > 0) std::memcpy(values.data(), rest_.data(), count * sizeof(T));
        rest_.remove_prefix(count * sizeof(T));
    }
    void finish() const {
        if (!rest_.empty()) refuse();
    }

private:
    template <class T>
    T take_one() {
        if (rest_.size() < sizeof(T)) refuse();
        T value;
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_.remove_prefix(sizeof value);
        return value;
    }
    [[noreturn]] void refuse() const {
        throw Fault(FaultKind::invalid, name_ + ": the importer's answer is cut short; export the mesh again");
    }

    std::string_view rest_;
    const std::string& name_;
};

}  // namespace

std::string to_bytes(const mesh::RawMesh& raw) {
    std::string bytes;
    std::vector<char> names;
    for (const std::string& name : raw.material_names)
        names.insert(names.end(), name.c_str(), name.c_str() + name.size() + 1);
    put(bytes, raw.points);
    put(bytes, raw.corners);
    put(bytes, raw.first);
    put(bytes, raw.material);
    put(bytes, names);
    return bytes;
}

mesh::RawMesh raw_mesh_from_bytes(std::string_view bytes, const std::string& name) {
    mesh::RawMesh raw;
    std::vector<char> names;
    Reader reader(bytes, name);
    reader.take(raw.points);
    reader.take(raw.corners);
    reader.take(raw.first);
    reader.take(raw.material);
    reader.take(names);
    reader.finish();
    for (std::size_t begin = 0; begin < names.size(); begin += raw.material_names.back().size() + 1)
        raw.material_names.emplace_back(names.data() + begin,
                                        ::strnlen(names.data() + begin, names.size() - begin));
    return raw;
}

}  // namespace orbweaver
