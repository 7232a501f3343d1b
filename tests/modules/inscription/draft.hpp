#pragma once

#include "orbs.hpp"

namespace orbweaver::test {

/// A draft of a web laid by hand. Once changed, points have moved sideways, further ones further, and threads
/// pull by turns; it keeps what it was asked for.
class HandMadeDraft final : public WebDraft {
public:
    explicit HandMadeDraft(HandMade web) : web_(std::move(web)), plain_(web_) {}

    const WebAtRest& plain() const noexcept override { return plain_; }
    const WebAtRest& changed(const WebChange& change) override {
        asked.push_back(change);
        after = test::changed(web_, change);
        for (std::size_t i = 0; i < after.points.size(); ++i)
            after.points[i] += 1e-5 * static_cast<double>(i % 50) * web_.right;
        for (std::size_t i = 0; i < after.tension.size(); ++i)
            after.tension[i] = i % 10 == 0 ? -0.5 : 1 + 0.25 * static_cast<double>(i % 4);
        changed_ = after;
        return changed_;
    }

    std::vector<WebChange> asked;
    HandMade after;  ///< as it was changed last

private:
    HandMade web_;
    WebAtRest plain_, changed_;
};

/// The same web, seen along another axis than z.
inline HandMade turned(HandMade web) {
    const Vec3 right{0.6, 0, -0.8}, up{0, 1, 0};
    for (Vec3& point : web.points) {
        const Vec3 from = point - web.center;
        point = web.center + dot(from, web.right) * right + dot(from, web.up) * up;
    }
    web.right = right;
    web.up = up;
    return web;
}

}  // namespace orbweaver::test
