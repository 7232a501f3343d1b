#include "study/study_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "study/svg_plot.hpp"

namespace orbweaver::study {

namespace {

constexpr const char* kStyle =
    "body{font:16px/1.5 sans-serif;color:#222;background:#fff;max-width:72em;margin:2em auto;padding:0 1em}"
    "h1{font-size:1.6em}h2{font-size:1.2em;margin-top:1.6em}table{border-collapse:collapse;font-size:.9em}"
    "td,th{padding:.15em .7em;text-align:right;border-bottom:1px solid #ddd}td:first-child,th:first-child"
    "{text-align:left}.front{font-weight:bold}svg{max-width:100%;height:auto}";

}  // namespace

FoldersToBe::FoldersToBe(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path whole = (fs::absolute(folder) / "").lexically_normal();
    for (fs::path each = whole.parent_path(); !fs::exists(fs::symlink_status(each, ignored));
         each = each.parent_path())
        folders_.push_back(each);
}

FoldersToBe::~FoldersToBe() {
    for (const std::filesystem::path& each : folders_) ::rmdir(each.c_str());  // but those that hold something
}

StudyFiles::StudyFiles(const std::string& folder, const std::vector<std::string>& names) : folders_(folder) {
    for (const std::string& name : names) files_.emplace_back(fmt::format("{}/{}", folder, name));
}

void StudyFiles::commit(const std::vector<std::string>& texts) {
    auto text = texts.begin();
    for (AtomicFile& file : files_) file.write(*text++);
    for (AtomicFile& file : files_) file.commit();
}

std::string html_page(const std::string& title, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</"
        "h1>\n"
        "{2}</body>\n</html>\n",
        escaped(title), kStyle, body);
}

std::string html_list(const std::vector<std::string>& sentences) {
    std::string items;
    for (const std::string& sentence : sentences) items += "<li>" + escaped(sentence) + "</li>\n";
    return "<ul>\n" + items + "</ul>\n";
}

}  // namespace orbweaver::study
