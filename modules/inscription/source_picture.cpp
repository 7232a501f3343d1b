#include "source_picture.hpp"

#include "dilate.hpp"
#include "line.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

Bitmap source_picture(const WebAtRest& web, const Page& page, std::span<const WebChange::Added> added) {
    Bitmap drawn(page.side, page.side);
    const auto draw = [&](std::uint32_t a, std::uint32_t b) {
        draw_line(drawn, page.spot(web.points[a]), page.spot(web.points[b]));
    };
    for (const ThreadSegment& thread : web.segments) draw(thread.a, thread.b);
    for (const WebChange::Added& thread : added) draw(thread.a, thread.b);
    return dilate(drawn, kDilation);
}

}  // namespace orbweaver::inscription
