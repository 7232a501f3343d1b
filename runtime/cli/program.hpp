#pragma once

#include <functional>

namespace orbweaver {

/// A program of ours from first to last: sets the process up, calls `body` for the exit code, turns whatever it
/// throws into a sentence on standard error and its exit code, and sees to it that results reach standard
/// output (1 when they cannot).
int guarded_main(const std::function<int()>& body);

}  // namespace orbweaver
