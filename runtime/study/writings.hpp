#pragma once

#include <string>
#include <vector>

#include "orbweaver/contracts/writing_ways.hpp"
#include "study/ways.hpp"
#include "study/web_readings.hpp"

namespace orbweaver::study {

/// What one way of writing came to, and what it cost the web of its nature.
struct TradeRow {
    std::string way;
    std::string setting;  ///< "loss 0.1"; empty: the way has none
    WritingWays::Outcome outcome;
};

struct WritingsResult {
    WaysResult ways;
    std::vector<TradeRow> trade;
    std::vector<ReadingRow> readings;  ///< none: it is no text, or there is no reader
};

/// Writes in the scene's web by every way, on rasters of several sizes, and with several losses of nature where
/// a way weighs them; photographs what came of each way, at rest and where there is wind while it sways, and
/// has it read. Throws Fault(invalid) for settings.methods that name no way.
WritingsResult study_writings(const StudySettings& settings, const std::string& scene, WritingWays& writing,
                              const std::vector<double>& times, const Deadline& deadline);

}  // namespace orbweaver::study
