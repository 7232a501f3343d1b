#pragma once

#include <functional>
#include <string>
#include <vector>

#include "orbweaver/contracts/writing_ways.hpp"
#include "run/run_scene.hpp"
#include "study/reading.hpp"
#include "study/web_pictures.hpp"

namespace orbweaver::study {

/// How well a reader that is not ours reads in the view's own picture; the plain web's rates are of the same
/// places.
struct ReadingRow {
    std::string way;
    double time = 0;  ///< s of the run
    bool is_blurred = false;
    std::string read;        ///< lines parted by '/'
    double error = 0;        ///< rate of characters, see character_error_rate()
    double plain_error = 0;  ///< of the web without inscription
};

/// Has the view's own pictures of what is written in a scene's web read, at some times of the run.
class WebReadings {
public:
    /// What is passed outlives it. `blur` (m) is the standard deviation through which a distant viewer reads.
    WebReadings(const RunSettings& run, const Reader& reader, const std::string& text, double blur,
                const std::vector<double>& times);

    /// Of one way, as it is and blurred, beside the same places of the web without inscription. Throws as
    /// photograph() and Reader::read() do, which heed `stop_asked`; another way may be asked for then.
    std::vector<ReadingRow> of(const std::string& way, const WritingWays::Outcome& written,
                               const std::function<bool()>& stop_asked = {});

private:
    /// Time by time, block by block.
    std::vector<BlockPictures> pictures_of(const RunSettings& run,
                                           const std::vector<WritingWays::Block>& blocks,
                                           const std::function<bool()>& stop_asked) const;
    std::string text_of(const BlockPictures* blocks, std::size_t count, bool blurred, bool dark,
                        const std::function<bool()>& stop_asked) const;

    RunSettings run_;
    const Reader& reader_;
    const std::string& text_;
    std::string alphabet_;  ///< of that
    double blur_;
    const std::vector<double>& times_;
    std::vector<WritingWays::Block> plain_blocks_;
    std::vector<BlockPictures> plain_;  ///< of those blocks, without inscription
};

}  // namespace orbweaver::study
