#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// Ways of writing in a web, for a study that holds legibility against cost, and against what is lost of the
/// web's nature. What is written stays in the study: the web of the scene is as the scene has it.
class WritingWays {
public:
    static constexpr const char* kContract = "writing_ways/1";

    struct Named {
        const char* name;     ///< "removal"
        const char* meaning;  ///< in a few words
    };
    /// What is not said is as the scene has it.
    struct Effort {
        std::optional<std::uint32_t> side;  ///< pixels of the raster on which it is written
        std::optional<double> loss;         ///< share of the web's silk that may change
    };
    /// Where words stand: a rectangle, its middle and the ways from there to its right and upper side.
    struct Block {
        Vec3 middle, right, up;  ///< m
    };
    /// Of a web at rest.
    struct Outcome {
        double iou = 0, ssim = 0, contrast = 1;
        double plain_iou = 0;          ///< of the same place before
        double silk_share = 0;         ///< silk added and removed, over the plain web's
        double max_tension_ratio = 1;  ///< over the plain web's
        double mean_shift = 0;         ///< m
        double spacing_distance = 0;   ///< 0 to 1
        std::size_t new_slack = 0;     ///< threads
        std::vector<Block> blocks;
    };

    virtual std::span<const Named> ways() const noexcept = 0;
    /// Whether a way heeds Effort::loss.
    virtual bool weighs_loss(std::size_t way) const noexcept = 0;
    /// What is written, lines parted by '\n'; empty: a picture.
    virtual const std::string& text() const noexcept = 0;
    /// False: the scene has no orb web, and nothing else here may be called.
    virtual bool has_web() const noexcept = 0;
    /// m, the standard deviation of the blur through which it is to be read.
    virtual double blur() const noexcept = 0;
    /// Writes and lets the web come to rest, all of which takes time. Every effort is judged on one fine
    /// raster.
    virtual Outcome write(std::size_t way, const Effort& effort) = 0;

protected:
    ~WritingWays() = default;
};

}  // namespace orbweaver
