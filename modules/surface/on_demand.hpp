#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>

namespace orbweaver::surface {

/// Something dear, made when it is first asked for: whoever never asks never has it. May be asked from several
/// threads; one makes it while the others wait.
template <class T>
class OnDemand {
public:
    explicit OnDemand(std::function<std::unique_ptr<const T>()> make) : make_(std::move(make)) {}

    /// Null when it could not be made: no memory. It is then tried again at the next call.
    const T* get() const noexcept {
        const T* made = ready_.load(std::memory_order_acquire);
        return made != nullptr ? made : make_now();
    }

    /// What was made so far, or null.
    const T* made() const noexcept { return ready_.load(std::memory_order_acquire); }

private:
    [[gnu::noinline]] const T* make_now() const noexcept {
        try {
            const std::scoped_lock lock(making_);
            if (made_ == nullptr) made_ = make_();
            ready_.store(made_.get(), std::memory_order_release);
        } catch (const std::exception&) {
            return nullptr;
        }
        return made_.get();
    }

    std::function<std::unique_ptr<const T>()> make_;
    mutable std::mutex making_;
    mutable std::unique_ptr<const T> made_;
    mutable std::atomic<const T*> ready_ = nullptr;
};

}  // namespace orbweaver::surface
