#pragma once

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "output/atomic_file.hpp"

namespace orbweaver::study {

/// Folders that somebody is about to make: those in which nothing lies in the end go with this.
class FoldersToBe {
public:
    /// Of a folder and those above it, all that are not there yet.
    explicit FoldersToBe(const std::string& folder);
    FoldersToBe(const FoldersToBe&) = delete;
    FoldersToBe& operator=(const FoldersToBe&) = delete;
    ~FoldersToBe();

private:
    std::vector<std::filesystem::path> folders_;  ///< the innermost first
};

/// The files of a study. All are opened when this is made, so that what cannot be written is known before
/// anything is run; none appears before commit(), and of a study that fails no folder stays either. Throws
/// Fault.
class StudyFiles {
public:
    StudyFiles(const std::string& folder, const std::vector<std::string>& names);
    /// A text for each of the names.
    void commit(const std::vector<std::string>& texts);

private:
    FoldersToBe folders_;
    std::list<AtomicFile> files_;
};

/// One HTML page that needs nothing else: `body` is HTML.
std::string html_page(const std::string& title, const std::string& body);
/// The sentences as a list in HTML.
std::string html_list(const std::vector<std::string>& sentences);

}  // namespace orbweaver::study
