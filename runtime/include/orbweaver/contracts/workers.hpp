#pragma once

#include <cstddef>
#include <type_traits>

namespace orbweaver {

/// Threads to share a loop among.
class Workers {
public:
    static constexpr const char* kContract = "workers/1";

    using Body = void (*)(void* context, std::size_t begin, std::size_t end) noexcept;
    /// Calls `body` on disjoint ranges that cover [0, count), none shorter than `grain` but the last;
    /// returns when all are done. The ranges differ from run to run: results must not depend on them.
    virtual void parallel_for(std::size_t count, std::size_t grain, Body body, void* context) noexcept = 0;

    template <class F>
    void for_each_range(std::size_t count, std::size_t grain, F&& f) noexcept {
        parallel_for(
            count, grain,
            [](void* context, std::size_t begin, std::size_t end) noexcept {
                (*static_cast<std::remove_reference_t<F>*>(context))(begin, end);
            },
            &f);
    }

protected:
    ~Workers() = default;
};

}  // namespace orbweaver
