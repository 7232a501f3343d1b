#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "orbweaver/state.hpp"

namespace orbweaver {

/// The memory behind one instance's StateStore.
class StateBlock final : public StateStore {
public:
    struct Entry {
        std::string name;
        ArrayInfo info;
        std::variant<std::vector<Vec3>, std::vector<double>, std::vector<std::uint64_t>> data;

        std::size_t count() const;
        std::size_t bytes() const;
        const void* memory() const;
        void* memory();
    };

    std::span<Vec3> vectors(std::string_view name, std::size_t count, ArrayInfo info) override;
    std::span<double> scalars(std::string_view name, std::size_t count, ArrayInfo info) override;
    std::span<std::uint64_t> words(std::string_view name, std::size_t count, ArrayInfo info) override;

    const std::deque<Entry>& entries() const noexcept { return entries_; }
    std::deque<Entry>& entries() noexcept { return entries_; }
    std::size_t bytes() const;

private:
    template <class T>
    std::span<T> make(std::string_view name, std::size_t count, ArrayInfo info);

    std::deque<Entry> entries_;  // a deque: entries stay where they are
};

}  // namespace orbweaver
