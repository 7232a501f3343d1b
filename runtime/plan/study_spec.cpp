#include "plan/study_spec.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plan/table_reader.hpp"
#include "scene/nearest_name.hpp"

namespace orbweaver {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

class StudyReader {
public:
    StudyReader(const Node& table, std::span<const OptionSpec> options, Diagnostics& faults)
        : table_(table), options_(options), faults_(faults) {}

    std::optional<StudySpec> read() {
        const std::size_t before = faults_.size();
        TableReader reader(table_, faults_);
        for (const auto& [key, into] :
             {std::pair("method", &spec_.method), std::pair("step", &spec_.step),
              std::pair("tolerance", &spec_.tolerance), std::pair("on_unstable", &spec_.on_unstable),
              std::pair("axis", &spec_.axis)})
            reader.take(key, *into);
        reader.take("numerics", spec_.numerics);
        reader.take("automatic", spec_.automatic);
        reader.take("steps", spec_.steps);
        reader.take("tolerances", spec_.tolerances);
        reader.take("references", spec_.references);
        reader.finish();
        if (faults_.size() == before) check();
        return faults_.size() == before ? std::optional(spec_) : std::nullopt;
    }

private:
    void check() {
        check_option("step", spec_.step, OptionType::number);
        check_option("axis", spec_.axis, OptionType::number);
        if (!spec_.tolerances.empty() || !spec_.tolerance.empty())
            check_option("tolerance", spec_.tolerance, OptionType::number);
        if (const OptionSpec* option = check_option("on_unstable", spec_.on_unstable, OptionType::choice))
            check_choices("on_unstable", {"as_asked", "substep"}, option->choices);
        if (const OptionSpec* option = check_option("method", spec_.method, OptionType::choice)) {
            check_choices("steps", spec_.steps, option->choices);
            check_choices("tolerances", spec_.tolerances, option->choices);
        }
        check_known("numerics", spec_.numerics);
        check_known("automatic", spec_.automatic);
        check_references();
    }

    void check_known(const char* key, const std::vector<std::string>& names) {
        for (const std::string& name : names)
            if (std::none_of(options_.begin(), options_.end(),
                             [&](const OptionSpec& o) { return o.key == name; }))
                fault(fmt::format("study.{} names \"{}\"", key, name), "names of options");
    }

    const OptionSpec* check_option(const char* key, const std::string& name, OptionType type) {
        const auto found = std::find_if(options_.begin(), options_.end(),
                                        [&](const OptionSpec& o) { return o.key == name && o.type == type; });
        if (found != options_.end()) return &*found;
        fault(fmt::format("study.{} is \"{}\"", key, name),
              fmt::format("the name of an option of type {}", to_string(type)));
        return nullptr;
    }

    void check_choices(const char* key, const std::vector<std::string>& names,
                       const std::vector<std::string>& choices) {
        for (const std::string& name : names)
            if (!contains(choices, name))
                fault(fmt::format("study.{} names \"{}\", which is no choice of its option", key, name),
                      join_names(choices));
    }

    void check_references() {
        const std::vector<std::string>& names = spec_.references;
        const bool two = names.size() == 2 && names[0] != names[1];
        const bool known = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
            return contains(spec_.steps, name) || contains(spec_.tolerances, name);
        });
        if (!two || !known)
            fault(fmt::format("study.references is \"{}\"", fmt::join(names, ", ")),
                  "two different methods of steps and tolerances");
    }

    void fault(std::string what, std::string expected) {
        faults_.push_back({table_.where, std::move(what), std::move(expected), ""});
    }

    const Node& table_;
    std::span<const OptionSpec> options_;
    Diagnostics& faults_;
    StudySpec spec_;
};

}  // namespace

std::optional<StudySpec> read_study(const Node& table, std::span<const OptionSpec> options,
                                    Diagnostics& faults) {
    if (table.table() != nullptr) return StudyReader(table, options, faults).read();
    faults.push_back({table.where, fmt::format("'study' is {}", show(table)), "a table", ""});
    return std::nullopt;
}

}  // namespace orbweaver
