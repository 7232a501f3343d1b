#include "run/state_block.hpp"

#include <fmt/format.h>

#include "orbweaver/fault.hpp"

namespace orbweaver {

std::size_t StateBlock::Entry::count() const {
    return std::visit([](const auto& v) { return v.size(); }, data);
}

std::size_t StateBlock::Entry::bytes() const {
    return std::visit([](const auto& v) { return v.size() * sizeof(v[0]); }, data);
}

const void* StateBlock::Entry::memory() const {
    return std::visit([](const auto& v) { return static_cast<const void*>(v.data()); }, data);
}

void* StateBlock::Entry::memory() {
    return std::visit([](auto& v) { return static_cast<void*>(v.data()); }, data);
}

template <class T>
std::span<T> StateBlock::make(std::string_view name, std::size_t count, ArrayInfo info) {
    for (const Entry& entry : entries_)
        if (entry.name == name)
            throw Fault(FaultKind::internal, fmt::format("state array '{}' was made twice", name));
    entries_.push_back({std::string(name), std::move(info), std::vector<T>(count)});
    return std::get<std::vector<T>>(entries_.back().data);
}

std::span<Vec3> StateBlock::vectors(std::string_view name, std::size_t count, ArrayInfo info) {
    return make<Vec3>(name, count, std::move(info));
}
std::span<double> StateBlock::scalars(std::string_view name, std::size_t count, ArrayInfo info) {
    return make<double>(name, count, std::move(info));
}
std::span<std::uint64_t> StateBlock::words(std::string_view name, std::size_t count, ArrayInfo info) {
    return make<std::uint64_t>(name, count, std::move(info));
}

std::size_t StateBlock::bytes() const {
    std::size_t sum = 0;
    for (const Entry& entry : entries_) sum += entry.bytes();
    return sum;
}

}  // namespace orbweaver
