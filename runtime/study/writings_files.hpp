#pragma once

#include <string>

#include "study/writings.hpp"

namespace orbweaver::study {

/// "way,setting,iou,ssim,contrast,plain_iou,silk_share,max_tension_ratio,mean_shift_m,spacing_distance,new_slack",
/// a line a row of the trade.
std::string trade_csv(const WritingsResult& result);
/// "way,time_s,blurred,read,error,plain_error", a line a reading; what was read in quotes where it needs them.
std::string readings_csv(const WritingsResult& result);
/// All of it.
std::string writings_json(const WritingsResult& result);
/// Legibility against silk that changed.
std::string trade_svg(const WritingsResult& result);
/// The plots, the sentences and the tables.
std::string writings_page(const WritingsResult& result);

}  // namespace orbweaver::study
