#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <sstream>

#include "manifest_text.hpp"
#include "orbweaver/entry.hpp"
#include "scribe.hpp"
#include "target_cache.hpp"
#include "target_file.hpp"
#include "target_options.hpp"
#include "writing_study.hpp"

namespace orbweaver::inscription {

namespace {

/// What was seen of a web while it moved: state.
struct Looks {
    std::span<std::uint64_t> count;  ///< one number
    std::span<double> iou;           ///< sum and least

    void add(double seen) {
        iou[1] = count[0] == 0 ? seen : std::min(iou[1], seen);
        iou[0] += seen;
        ++count[0];
    }
    double mean() const { return iou[0] / static_cast<double>(count[0]); }
};

/// A web that was written in, as it moves.
struct WrittenWeb {
    const Threads& threads;
    Inscription inscription;
    std::optional<Looks> looks;  ///< only if asked for

    double iou_now() const {
        return measure_legibility(threads.points(), threads.segments(), inscription.lettering).iou;
    }
};

ModeSettings settings_of(const Options& options) {
    ModeSettings settings;
    settings.score_threshold = static_cast<int>(options.integer("score_threshold"));
    settings.width = options.number("thickness");
    settings.attachments = options.number("attachments");
    settings.outline = options.number("outline");
    settings.loss = options.number("naturalness_loss");
    return settings;
}

/// Lines of a text that have something in them.
std::size_t lines_of(const std::string& text) {
    std::istringstream all(text);
    std::size_t count = 0;
    for (std::string line; std::getline(all, line);)
        if (line.find_first_not_of(' ') != std::string::npos) ++count;
    return count;
}

WhereToWrite place_of(const Options& options, const std::string& text) {
    WhereToWrite where;
    if (options.has("position"))
        where.position = {options.numbers("position")[0], options.numbers("position")[1]};
    if (options.has("size")) where.size = options.number("size");
    where.lines = std::max(where.lines, lines_of(text));
    where.side = static_cast<std::uint32_t>(options.integer("resolution"));
    where.blur = options.number("blur");
    return where;
}

}  // namespace

/// The [inscription] table: writes in the orb webs of the scene, and measures how well that can be read.
class InscriptionModule final : public Module, public Inscriber {
public:
    void attach(Host& host) override {
        host_ = &host;
        const Options& options = host.options();
        source_ = options.has("target") ? "target" : options.has("text") ? "text" : "gaps";
        for (Diagnostic& fault : idle_options(options)) host.report_fault(std::move(fault));
        try {
            file_.emplace(open_target(target_recipe(options)));
            const std::string text = words_in(recipe_in(*file_)).value_or("");
            scribe_.emplace(Scribe{find_mode(options.text("mode")),
                                   target_in(*file_),
                                   place_of(options, text),
                                   settings_of(options),
                                   host.random("attachments"),
                                   {}});
            study_.emplace(*scribe_, text);
        } catch (const Fault& fault) {
            host.report_fault({where({source_}), fault.what(), "", ""});
            return;
        }
        if (options.has("watch")) watch_ = options.number("watch");
        const auto& asked = host.request().collects;
        is_studied_ = std::find(asked.begin(), asked.end(), WritingWays::kContract) != asked.end();
        host.telemetry("iou", [this] { return webs_.empty() ? 0 : webs_.front().iou_now(); });
        host.provide<Inscriber>(*this);
        host.provide<WritingWays>(*study_);
    }

    /// A web that finds nobody who writes in it is no orb web.
    void meet(Host& host) override {
        if (asked_ == 0)
            host.report_fault({where({source_}), "the scene has no orb web to write in",
                               "a table [web] with anchors, or with a species such as araneus_cavaticus",
                               "or leave [inscription] out"});
    }

    /// What cannot be written is the scene's fault in [inscription], not in the web's own table.
    void inscribe(WebDraft& draft, const Threads& threads) override {
        ++asked_;
        try {
            write(draft, threads);
        } catch (const Fault& fault) {
            if (fault.kind() != FaultKind::invalid) throw;
            host_->report_fault({where({"size", "position", source_}), fault.what(), "", ""});
        }
    }

    bool keeps_draft() const noexcept override { return is_studied_; }

    void run(Phase, const Frame& frame) override {
        if (!(watch_ > 0) || !is_due(frame)) return;
        for (WrittenWeb& each : webs_) each.looks->add(each.iou_now());
    }

    void report(ModuleReport& report) override {
        report.method = scribe_->mode->name;
        if (webs_.empty()) return;
        const WrittenWeb& worst =
            *std::min_element(webs_.begin(), webs_.end(), [](const WrittenWeb& a, const WrittenWeb& b) {
                return a.inscription.at_rest.iou < b.inscription.at_rest.iou;
            });
        report.has_error = true;
        report.error = {1 - worst.inscription.at_rest.iou, "1",
                        "share of target and what is read, together, in which they differ; written at rest",
                        seconds_};
        for (const WrittenWeb& each : webs_)
            report.memory_bytes += each.inscription.lettering.coverage.values.size();
        report_place(worst.inscription.lettering, report);
        report_legibility(worst, report);
        report_cost(worst.inscription, report);
    }

private:
    void write(WebDraft& draft, const Threads& threads) {
        const auto start = std::chrono::steady_clock::now();
        webs_.push_back({threads, scribe_->write(draft), {}});
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (is_studied_ && !study_->has_web()) study_->write_in(draft);
        if (watch_ > 0) webs_.back().looks = make_looks();
        warn_of_cut(webs_.back().inscription.lettering);
    }

    Looks make_looks() const {
        const std::size_t number = webs_.size();
        return {host_->state().words(fmt::format("looks_{}", number), 1,
                                     {"1", "times that legibility was measured", false}),
                host_->state().scalars(fmt::format("iou_swaying_{}", number), 2,
                                       {"1", "agreement, summed over these times, and the least", false})};
    }

    void warn_of_cut(const Lettering& lettering) const {
        if (lettering.cut_share() < kCutShare) return;
        host_->log(
            LogLevel::warning,
            fmt::format("{:.0f} % of what is to be written lies beside the web's page and is cut; give another "
                        "'position' or 'size'",
                        100 * lettering.cut_share()));
    }

    /// Of the first of some options that the scene gives; else of the table.
    Location where(std::initializer_list<const char*> keys) const {
        const Options& options = host_->options();
        for (const char* key : keys)
            if (options.given(key)) return options.where(key);
        return options.where(source_);
    }

    /// Whether this frame is the first to end at or beyond another multiple of the time between looks.
    bool is_due(const Frame& frame) const {
        const auto looks = [&](double time) { return std::floor(time / watch_ + 1e-9); };
        return looks(frame.time + frame.step) > looks(frame.time);
    }

    /// Of each block, in the web's plane.
    static void report_place(const Lettering& lettering, ModuleReport& report) {
        const Page& page = lettering.page;
        for (std::size_t i = 0; i < lettering.blocks.size(); ++i) {
            const Box& block = lettering.blocks[i];
            const Vec3 low = page.point({static_cast<double>(block.left), static_cast<double>(block.bottom)});
            const Vec3 high = page.point({static_cast<double>(block.right), static_cast<double>(block.top)});
            const std::string name = fmt::format("block_{}_", i + 1);
            report.measure(name + "left_m", dot(low, page.right));
            report.measure(name + "bottom_m", dot(low, page.up));
            report.measure(name + "right_m", dot(high, page.right));
            report.measure(name + "top_m", dot(high, page.up));
        }
    }

    static void report_legibility(const WrittenWeb& web, ModuleReport& report) {
        const auto& [iou, ssim, contrast] = web.inscription.at_rest;
        const Legibility& plain = web.inscription.plain;
        report.measure("blur_m", web.inscription.lettering.blur);
        report.measure("iou", iou);
        report.measure("iou_plain", plain.iou);
        report.measure("ssim", ssim);
        report.measure("ssim_plain", plain.ssim);
        report.measure("contrast", contrast);
        report.measure("contrast_plain", plain.contrast);
        report.measure("cut_share", web.inscription.lettering.cut_share());
        if (!web.looks || web.looks->count[0] == 0) return;
        report.measure("iou_swaying_mean", web.looks->mean());
        report.measure("iou_swaying_least", web.looks->iou[1]);
    }

    static void report_cost(const Inscription& web, ModuleReport& report) {
        const Naturalness& cost = web.naturalness;
        report.measure("threads_removed", static_cast<std::int64_t>(web.removed));
        report.measure("threads_added", static_cast<std::int64_t>(web.added));
        report.measure("parts_thickened", static_cast<std::int64_t>(web.thickened));
        report.measure("silk_removed_m", cost.silk_removed);
        report.measure("silk_added_m", cost.silk_added);
        report.measure("naturalness_loss", cost.silk_share);
        report.measure("max_tension_ratio", cost.max_tension_ratio);
        report.measure("max_tension_change_n", cost.tension_change);
        report.measure("mean_shift_m", cost.mean_shift);
        report.measure("new_slack_threads", static_cast<std::int64_t>(cost.new_slack));
        report.measure("spacing_distance", cost.spacing_distance);
    }

    static constexpr double kCutShare = 0.01;  // less than that is no letter's part

    Host* host_ = nullptr;
    const char* source_ = "";  // option that says what is inscribed
    std::optional<BakedFile> file_;
    std::optional<Scribe> scribe_;  // of a target in file_
    double watch_ = 0;              // s between looks; 0: none
    std::size_t asked_ = 0;         // by webs
    std::vector<WrittenWeb> webs_;
    double seconds_ = 0;  // s that writing took
    bool is_studied_ = false;
    std::optional<WritingStudy> study_;  // of the first web
};

}  // namespace orbweaver::inscription

ORBWEAVER_MODULE(orbweaver::inscription::InscriptionModule)
