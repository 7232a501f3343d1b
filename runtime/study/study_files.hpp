#pragma once

#include <list>
#include <string>
#include <vector>

#include "output/atomic_file.hpp"

namespace orbweaver::study {

/// The files of a study. All are opened when this is made, so that what cannot be written is known before
/// anything is run; none appears before commit(). Throws Fault.
class StudyFiles {
public:
    StudyFiles(const std::string& folder, const std::vector<std::string>& names);
    /// A text for each of the names.
    void commit(const std::vector<std::string>& texts);

private:
    std::list<AtomicFile> files_;
};

/// One HTML page that needs nothing else: `body` is HTML.
std::string html_page(const std::string& title, const std::string& body);
/// The sentences as a list in HTML.
std::string html_list(const std::vector<std::string>& sentences);

}  // namespace orbweaver::study
