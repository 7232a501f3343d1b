#pragma once

#include <stdlib.h>

#include <map>
#include <string>

namespace orbweaver::test {

/// The variables that say where the cache is: unset at first, put back in the end.
class CacheEnvironment {
public:
    CacheEnvironment() {
        for (const char* name : {"ORBWEAVER_CACHE", "XDG_CACHE_HOME", "HOME"}) {
            const char* value = std::getenv(name);
            before_[name] = value == nullptr ? "" : value;
            ::unsetenv(name);
        }
    }
    ~CacheEnvironment() {
        for (const auto& [name, value] : before_)
            value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
    }
    CacheEnvironment(const CacheEnvironment&) = delete;
    CacheEnvironment& operator=(const CacheEnvironment&) = delete;

private:
    std::map<std::string, std::string> before_;
};

}  // namespace orbweaver::test
