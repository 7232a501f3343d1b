#pragma once

#include <string>
#include <vector>

#include "output/atomic_file.hpp"

namespace orbweaver::study {

/// The four files of a study, NAME.csv, NAME.json, NAME.svg and index.html. All are opened when this is made,
/// so that what cannot be written is known before anything is run; none appears before commit(). Throws Fault.
class StudyFiles {
public:
    StudyFiles(const std::string& folder, const std::string& name);
    void commit(const std::string& csv, const std::string& json, const std::string& svg,
                const std::string& page);

private:
    AtomicFile csv_, json_, svg_, page_;
};

/// One HTML page that needs nothing else: `body` is HTML.
std::string html_page(const std::string& title, const std::string& body);
/// The sentences as a list in HTML.
std::string html_list(const std::vector<std::string>& sentences);

}  // namespace orbweaver::study
