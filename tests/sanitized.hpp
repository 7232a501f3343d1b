#pragma once

namespace orbweaver {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// A number of repetitions: a tenth of it under sanitizers, which take twenty times as long and look for what every
/// repetition does alike.
constexpr int repetitions(int count) { return kSanitized ? (count + 9) / 10 : count; }

}  // namespace orbweaver
