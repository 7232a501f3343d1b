#pragma once

#include <string>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "scene/node.hpp"

namespace orbweaver {

/// Takes the members of one table by name and type, and reports what is wrong or left over.
class TableReader {
public:
    /// `node` is a table, of what `owner` says; all must live as long as the reader.
    TableReader(const Node& node, Diagnostics& faults, const char* owner = "a manifest")
        : node_(node), faults_(faults), owner_(owner) {}

    /// The member of that name, or null.
    const Node* take(const std::string& key);
    /// Each leaves `into` as it is when the member is absent or of another type; the latter is a fault.
    void take(const std::string& key, bool& into);
    void take(const std::string& key, std::int64_t& into);
    void take(const std::string& key, std::string& into);
    void take(const std::string& key, std::vector<std::string>& into);
    /// False when the member is absent.
    bool take_number(const std::string& key, double& into);

    void wrong(const Node& node, const std::string& key, const std::string& expected);
    void missing(const std::string& key);
    /// Reports every member that nobody took.
    void finish();

private:
    template <class T>
    void take_as(const std::string& key, T& into, const char* expected);

    const Node& node_;
    Diagnostics& faults_;
    const char* owner_;
    std::vector<std::string> known_;
};

}  // namespace orbweaver
