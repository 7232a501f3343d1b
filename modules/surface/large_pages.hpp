#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace orbweaver::surface {

/// Memory in pages of 2 MiB, where the system has them and the array is as large: what is read here and there
/// then costs no walk through tables of small pages first.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    explicit LargePages(const LargePages<Other>&) noexcept {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        const std::size_t page = bytes < kPage ? alignof(T) : kPage;
        void* memory = std::aligned_alloc(page, (bytes + page - 1) / page * page);
        if (memory == nullptr) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
        if (page == kPage) ::madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: without it all is as it was
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t) noexcept { std::free(memory); }

    friend bool operator==(const LargePages&, const LargePages&) noexcept { return true; }

private:
    static constexpr std::size_t kPage = std::size_t{2} << 20;
};

}  // namespace orbweaver::surface
