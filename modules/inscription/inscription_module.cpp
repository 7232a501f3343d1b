#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "dilate.hpp"
#include "lettering.hpp"
#include "manifest_text.hpp"
#include "mode.hpp"
#include "naturalness.hpp"
#include "orbweaver/entry.hpp"
#include "target_cache.hpp"
#include "target_file.hpp"
#include "target_options.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kMostTension = 1.5;  ///< of the plain web's largest, in a web that is written in legibly

/// What was written in one web.
struct Written {
    const Threads& threads;
    Lettering lettering;
    Naturalness naturalness;
    Legibility plain;                                   ///< of the same place before
    Legibility at_rest;                                 ///< after
    std::size_t removed = 0, added = 0, thickened = 0;  ///< threads, and parts of them
    std::size_t watched = 0;
    double iou_sum = 0;  ///< while it moves
    double iou_least = std::numeric_limits<double>::infinity();

    Legibility now() const { return measure_legibility(threads.points(), threads.segments(), lettering); }
    void watch(double iou) {
        ++watched;
        iou_sum += iou;
        iou_least = std::min(iou_least, iou);
    }
};

bool is_spoilt(const Naturalness& cost) { return cost.new_slack > 0 || cost.max_tension_ratio > kMostTension; }

ModeSettings settings_of(const Options& options) {
    ModeSettings settings;
    settings.score_threshold = static_cast<int>(options.integer("score_threshold"));
    settings.width = options.number("thickness");
    settings.attachments = options.number("attachments");
    settings.outline = options.number("outline");
    settings.loss = options.number("naturalness_loss");
    return settings;
}

WhereToWrite place_of(const Options& options, const TargetRecipe& recipe) {
    WhereToWrite where;
    if (options.has("position"))
        where.position = {options.numbers("position")[0], options.numbers("position")[1]};
    if (options.has("size")) where.size = options.number("size");
    where.best_place = options.text("mode") == "legible";
    if (recipe.text)
        where.lines += static_cast<std::size_t>(std::count(recipe.text->begin(), recipe.text->end(), '\n'));
    where.most_ink = options.number("naturalness_loss") / std::max(options.number("thickness") - 1, 1e-3);
    where.side = static_cast<std::uint32_t>(options.integer("resolution"));
    where.blur = options.number("blur");
    return where;
}

}  // namespace

/// The [inscription] table: writes in the orb webs of the scene, and measures how well that can be read.
class InscriptionModule final : public Module, public Inscriber {
public:
    void attach(Host& host) override {
        const Options& options = host.options();
        try {
            const TargetRecipe recipe = target_recipe(options);
            file_.emplace(open_target(recipe));
            target_ = target_in(*file_);
            where_ = place_of(options, recipe);
        } catch (const Fault& fault) {
            const char* source = options.has("target") ? "target" : (options.has("text") ? "text" : "mode");
            host.report_fault({options.where(source), fault.what(), "", ""});
            return;
        }
        mode_ = find_mode(options.text("mode"));
        settings_ = settings_of(options);
        random_.emplace(host.random("attachments"));
        if (options.has("watch")) watch_ = options.number("watch");
        host.telemetry("iou", [this] { return written_.empty() ? 0 : written_.front().now().iou; });
        host.provide<Inscriber>(*this);
    }

    void inscribe(WebDraft& draft, const Threads& threads) override {
        const auto start = std::chrono::steady_clock::now();
        const WebAtRest& plain = draft.plain();
        Written written{threads, lay_on(plain, target_, where_), {}, {}, {}};
        write(draft, settings_, written);
        if (mode_->name == "legible" && is_spoilt(written.naturalness)) {
            ModeSettings gentle = settings_;
            gentle.take = false;
            write(draft, gentle, written);
        }
        written.plain = measure_legibility(plain.points, plain.segments, written.lettering);
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        written_.push_back(std::move(written));
    }

    void run(Phase, const Frame& frame) override {
        if (!(watch_ > 0) || !is_due(frame)) return;
        for (Written& each : written_) each.watch(each.now().iou);
    }

    void report(ModuleReport& report) override {
        report.method = mode_->name;
        if (written_.empty()) return;
        const Written& worst =
            *std::min_element(written_.begin(), written_.end(),
                              [](const Written& a, const Written& b) { return a.at_rest.iou < b.at_rest.iou; });
        report.has_error = true;
        report.error = {1 - worst.at_rest.iou, "1",
                        "share of target and what is read, together, in which they differ; written at rest",
                        seconds_};
        for (const Written& each : written_) report.memory_bytes += each.lettering.coverage.values.size();
        report_legibility(worst, report);
        report_naturalness(worst, report);
    }

private:
    void write(WebDraft& draft, const ModeSettings& settings, Written& written) const {
        const WebAtRest& plain = draft.plain();
        const Lettering& lettering = written.lettering;
        const Bitmap dilated = dilate(lettering.coverage, kDilation);
        const WebChange change = mode_->write({plain, lettering.page, lettering.coverage, dilated,
                                               plain.mesh_width, lettering.blur, settings, *random_});
        const WebAtRest& changed = draft.changed(change);
        written.naturalness = compare(plain, change, changed);
        written.at_rest = measure_legibility(changed.points, changed.segments, lettering);
        written.removed = change.removed.size();
        written.added = change.added.size();
        written.thickened = change.thickened.size();
    }

    /// Whether a frame is the first that ends at a multiple of the time between two looks or later.
    bool is_due(const Frame& frame) const {
        const auto looks = [&](double time) { return std::floor(time / watch_ + 1e-9); };
        return looks(frame.time + frame.step) > looks(frame.time);
    }

    static void report_legibility(const Written& web, ModuleReport& report) {
        report_place(web.lettering, report);
        report.measure("blur_m", web.lettering.blur);
        report.measure("iou", web.at_rest.iou);
        report.measure("iou_plain", web.plain.iou);
        report.measure("ssim", web.at_rest.ssim);
        report.measure("ssim_plain", web.plain.ssim);
        report.measure("contrast", web.at_rest.contrast);
        report.measure("contrast_plain", web.plain.contrast);
        if (web.watched == 0) return;
        report.measure("iou_swaying_mean", web.iou_sum / static_cast<double>(web.watched));
        report.measure("iou_swaying_least", web.iou_least);
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

    static void report_naturalness(const Written& web, ModuleReport& report) {
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

    std::optional<BakedFile> file_;
    Target target_;  // in file_
    WhereToWrite where_;
    const Mode* mode_ = nullptr;
    ModeSettings settings_;
    std::optional<RandomStream> random_;
    double watch_ = 0;  // s between looks; 0: none
    std::vector<Written> written_;
    double seconds_ = 0;  // s that writing took
};

}  // namespace orbweaver::inscription

ORBWEAVER_MODULE(orbweaver::inscription::InscriptionModule)
