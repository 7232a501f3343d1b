#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace orbweaver {

/// What a child may use before it is ended.
struct ChildLimits {
    std::size_t memory = std::size_t{4} << 30;  ///< bytes resident, and bytes of its answer
    double seconds = 120;                       ///< wall clock
};

/// Runs code that is not trusted in a process of its own and returns its answer. The child writes no files,
/// leaves no core, outlives neither us nor its limits, and says nothing on our streams. A Fault that `work`
/// throws arrives as it is. Throws Fault(invalid) when the child crashes, Fault(limit) when it runs out of
/// memory or time; `name` stands for what it works on in the sentence. Only for processes of one thread: what
/// other threads hold stays locked in the child.
std::string run_in_child(const std::string& name, const ChildLimits& limits,
                         const std::function<std::string()>& work);

}  // namespace orbweaver
