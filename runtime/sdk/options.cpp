#include "orbweaver/options.hpp"

#include <algorithm>

#include "orbweaver/fault.hpp"

namespace orbweaver {

void Options::set(std::string key, OptionValue value, Location where) {
    entries_.insert_or_assign(std::move(key), Entry{std::move(value), std::move(where)});
}

bool Options::has(std::string_view key) const noexcept { return entries_.find(key) != entries_.end(); }

bool Options::given(std::string_view key) const noexcept {
    const auto found = entries_.find(key);
    return found != entries_.end() && !found->second.where.file.empty();
}

Location Options::where(std::string_view key) const {
    const auto found = entries_.find(key);
    return found != entries_.end() && !found->second.where.file.empty() ? found->second.where : table_;
}

std::vector<std::string> Options::names_in(std::string_view group) const {
    const std::string prefix = std::string(group) + ".";
    std::vector<std::string> names;
    for (auto entry = entries_.lower_bound(prefix); entry != entries_.end(); ++entry) {
        const std::string& key = entry->first;
        if (!key.starts_with(prefix)) break;
        names.push_back(key.substr(prefix.size(), key.rfind('.') - prefix.size()));
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

template <class T>
const T& Options::get(std::string_view key, const char* type) const {
    const auto found = entries_.find(key);
    if (found == entries_.end())
        throw Fault(FaultKind::internal, "option '" + std::string(key) + "' has no value; ask has() first");
    const T* value = std::get_if<T>(&found->second.value);
    if (value == nullptr)
        throw Fault(FaultKind::internal, "option '" + std::string(key) + "' is not declared as " + type);
    return *value;
}

bool Options::flag(std::string_view key) const { return get<bool>(key, "boolean"); }
std::int64_t Options::integer(std::string_view key) const { return get<std::int64_t>(key, "integer"); }
double Options::number(std::string_view key) const { return get<double>(key, "number"); }
const std::string& Options::text(std::string_view key) const { return get<std::string>(key, "text"); }
const Vec3& Options::vector(std::string_view key) const { return get<Vec3>(key, "vector"); }
const std::vector<double>& Options::numbers(std::string_view key) const {
    return get<std::vector<double>>(key, "numbers");
}
const std::vector<Vec3>& Options::vectors(std::string_view key) const {
    return get<std::vector<Vec3>>(key, "vectors");
}

}  // namespace orbweaver
