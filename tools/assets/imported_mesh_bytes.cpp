#include "imported_mesh_bytes.hpp"

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

/// Each ended by a zero.
void put_texts(std::string& bytes, const std::vector<std::string>& texts) {
    std::vector<char> all;
    for (const std::string& text : texts) all.insert(all.end(), text.c_str(), text.c_str() + text.size() + 1);
    put(bytes, all);
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
    void take_texts(std::vector<std::string>& texts) {
        std::vector<char> all;
        take(all);
        for (std::size_t begin = 0; begin < all.size(); begin += texts.back().size() + 1)
            texts.emplace_back(all.data() + begin, ::strnlen(all.data() + begin, all.size() - begin));
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

std::string to_bytes(const ImportedMesh& mesh) {
    std::string bytes;
    put(bytes, mesh.raw.points);
    put(bytes, mesh.raw.corners);
    put(bytes, mesh.raw.first);
    put(bytes, mesh.raw.material);
    put_texts(bytes, mesh.raw.material_names);
    put_texts(bytes, mesh.companions);
    return bytes;
}

ImportedMesh imported_mesh_from_bytes(std::string_view bytes, const std::string& name) {
    ImportedMesh mesh;
    Reader reader(bytes, name);
    reader.take(mesh.raw.points);
    reader.take(mesh.raw.corners);
    reader.take(mesh.raw.first);
    reader.take(mesh.raw.material);
    reader.take_texts(mesh.raw.material_names);
    reader.take_texts(mesh.companions);
    reader.finish();
    return mesh;
}

}  // namespace orbweaver
