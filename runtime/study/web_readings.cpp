#include "study/web_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace orbweaver::study {

namespace {

constexpr double kPixelsPerBlur = 6;  ///< of a photograph, in the deviation of the blur
constexpr double kMargin = 1.5;       ///< blurs around a block

std::string in_one_line(std::string text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', '/');
    return text;
}

bool same_place(const std::vector<WritingWays::Block>& one, const std::vector<WritingWays::Block>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const auto& a, const auto& b) {
        return a.middle == b.middle && a.right == b.right && a.up == b.up;
    });
}

/// Whatever the scene and the command line said of it.
RunSettings without_inscription(RunSettings run) {
    run.removals.emplace_back("inscription");
    std::erase_if(run.overrides, [](const std::string& text) {
        return text.starts_with("inscription.") || text.starts_with("inscription=");
    });
    return run;
}

}  // namespace

WebReadings::WebReadings(const RunSettings& run, const Reader& reader, const std::string& text, double blur,
                         const std::vector<double>& times)
    : run_(run), reader_(reader), text_(text), alphabet_(alphabet_of(text)), blur_(blur), times_(times) {
    run_.request.collects.clear();
}

std::vector<ReadingRow> WebReadings::of(const std::string& way, const WritingWays::Outcome& written,
                                        const std::function<bool()>& stop_asked) {
    RunSettings run = run_;
    run.overrides.push_back(fmt::format("inscription.mode=\"{}\"", way));
    const std::vector<BlockPictures> pictures = pictures_of(run, written.blocks, stop_asked);
    if (!same_place(plain_blocks_, written.blocks)) {
        plain_ = pictures_of(without_inscription(run_), written.blocks, stop_asked);
        plain_blocks_ = written.blocks;
    }
    const bool dark = written.contrast >= 1;
    const std::size_t blocks = written.blocks.size();
    std::vector<ReadingRow> rows;
    for (const bool blurred : {false, true})
        for (std::size_t i = 0; i < times_.size(); ++i) {
            const std::string read = text_of(&pictures[i * blocks], blocks, blurred, dark, stop_asked);
            const std::string plain = text_of(&plain_[i * blocks], blocks, blurred, dark, stop_asked);
            rows.push_back({way, times_[i], blurred, in_one_line(read), character_error_rate(read, text_),
                            character_error_rate(plain, text_)});
        }
    return rows;
}

std::vector<BlockPictures> WebReadings::pictures_of(const RunSettings& run,
                                                    const std::vector<WritingWays::Block>& blocks,
                                                    const std::function<bool()>& stop_asked) const {
    std::vector<BlockPictures> all;
    const Photograph how{blocks, kMargin * blur_, blur_, blur_ / kPixelsPerBlur};
    for (auto& at_a_time : photograph(run, how, times_, stop_asked))
        std::move(at_a_time.begin(), at_a_time.end(), std::back_inserter(all));
    return all;
}

std::string WebReadings::text_of(const BlockPictures* blocks, std::size_t count, bool blurred, bool dark,
                                 const std::function<bool()>& stop_asked) const {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        picture::GrayPicture picture = blurred ? blocks[i].blurred : blocks[i].plain;
        if (!dark)
            for (std::uint8_t& shade : picture.shades) shade = static_cast<std::uint8_t>(255 - shade);
        text += reader_.read(picture, alphabet_, stop_asked);
    }
    return text;
}

}  // namespace orbweaver::study
