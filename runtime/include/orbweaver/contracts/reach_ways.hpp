#pragma once

#include <cstddef>
#include <span>

namespace orbweaver {

/// Ways of bringing the ends of limbs to places, for a study that holds their errors and costs against each
/// other.
class ReachWays {
public:
    static constexpr const char* kContract = "reach_ways/1";

    struct Named {
        const char* name;     ///< "half_jacobian", "cold"
        const char* meaning;  ///< in a few words
    };
    /// How much trouble a search may take.
    struct Effort {
        double tolerance = 0;  ///< of the limb's length, within which it may end; 0: it goes on
        int steps = 0;         ///< after which it ends; 0: as many as are usual, and from other beginnings too
    };
    /// Where a limb's end came to.
    struct Reach {
        double error = 0;      ///< from its target, in lengths of the limb
        bool claimed = false;  ///< the way says that it is within the tolerance
    };

    virtual std::size_t limbs() const noexcept = 0;
    virtual std::span<const Named> ways() const noexcept = 0;
    /// Kinds of targets.
    virtual std::span<const Named> kinds() const noexcept = 0;
    /// How many there are of a kind, of all limbs together.
    virtual std::size_t count(std::size_t kind) const noexcept = 0;
    /// Bends the limbs to each target of a kind. `reaches` has a place for each of them; or is empty, and the
    /// way's own work is all that is done.
    virtual void reach(std::size_t way, std::size_t kind, const Effort& effort, std::span<Reach> reaches) = 0;

protected:
    ~ReachWays() = default;
};

}  // namespace orbweaver
