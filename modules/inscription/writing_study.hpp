#pragma once

#include <string>

#include "orbweaver/contracts/writing_ways.hpp"
#include "scribe.hpp"

namespace orbweaver::inscription {

/// The modes as ways of writing in one draft.
class WritingStudy final : public WritingWays {
public:
    /// `text` is empty for a picture.
    WritingStudy(const Scribe& scribe, std::string text) : scribe_(scribe), text_(std::move(text)) {
        scribe_.judged_on = kJudgedOn;
    }
    /// From now on there is a web, which outlives it.
    void write_in(WebDraft& draft) noexcept { draft_ = &draft; }

    std::span<const Named> ways() const noexcept override;
    bool weighs_loss(std::size_t way) const noexcept override;
    const std::string& text() const noexcept override { return text_; }
    bool has_web() const noexcept override { return draft_ != nullptr; }
    double blur() const noexcept override { return scribe_.where.blur * draft_->plain().mesh_width; }
    Outcome write(std::size_t way, const Effort& effort) override;

private:
    static constexpr std::uint32_t kJudgedOn = 1200;

    WebDraft* draft_ = nullptr;
    Scribe scribe_;
    std::string text_;
};

}  // namespace orbweaver::inscription
