// Queries of the surface against Embree 3 and Bullet, in one process, on the same mesh and rays. Debian's
// Embree has its assertions compiled in (its package is built without NDEBUG), which costs it something.

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../../modules/surface/walk_samples.hpp"
#include "fcl_tree.hpp"
#include "underfoot.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::surface;

double thread_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Embree {
public:
    Embree(const TriangleSet& set, RTCSceneFlags flags)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), set.vertices.size()));
        for (const Vec3& v : set.vertices)
            for (const double each : {v.x, v.y, v.z}) *points++ = static_cast<float>(each);
        auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), set.triangles.size()));
        for (const Corners& c : set.triangles)
            for (const std::uint32_t each : c) *corners++ = each;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    double first_hit(const SurfaceRay& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit asked{};
        asked.ray.org_x = static_cast<float>(ray.origin.x);
        asked.ray.org_y = static_cast<float>(ray.origin.y);
        asked.ray.org_z = static_cast<float>(ray.origin.z);
        asked.ray.dir_x = static_cast<float>(ray.direction.x);
        asked.ray.dir_y = static_cast<float>(ray.direction.y);
        asked.ray.dir_z = static_cast<float>(ray.direction.z);
        asked.ray.tfar = static_cast<float>(ray.reach);
        asked.ray.mask = 0xFFFFFFFF;
        asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &asked);
        return asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : asked.ray.tfar;
    }

private:
    RTCDevice device_;
    RTCScene scene_;
};

class Bullet {
public:
    explicit Bullet(const TriangleSet& set) {
        for (const Vec3& v : set.vertices) points_.insert(points_.end(), {v.x, v.y, v.z});
        for (const Corners& c : set.triangles)
            for (const std::uint32_t each : c) corners_.push_back(static_cast<int>(each));
        arrays_ = std::make_unique<btTriangleIndexVertexArray>(
            static_cast<int>(set.triangles.size()), corners_.data(), 3 * static_cast<int>(sizeof(int)),
            static_cast<int>(set.vertices.size()), points_.data(), 3 * static_cast<int>(sizeof(btScalar)));
        shape_ = std::make_unique<btBvhTriangleMeshShape>(arrays_.get(), true);
    }

    double first_hit(const SurfaceRay& ray, double farthest) const {
        const double reach = std::min(ray.reach, farthest);
        const Vec3 end = ray.origin + reach * ray.direction;
        Nearest nearest({ray.origin.x, ray.origin.y, ray.origin.z}, {end.x, end.y, end.z});
        shape_->performRaycast(&nearest, nearest.m_from, nearest.m_to);
        return nearest.m_hitFraction < 1 ? nearest.m_hitFraction * reach : -1;
    }

private:
    struct Nearest : btTriangleRaycastCallback {
        Nearest(const btVector3& from, const btVector3& to) : btTriangleRaycastCallback(from, to) {}
        btScalar reportHit(const btVector3&, btScalar fraction, int, int) override { return fraction; }
    };

    std::vector<btScalar> points_;
    std::vector<int> corners_;
    std::unique_ptr<btTriangleIndexVertexArray> arrays_;
    std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

struct Contender {
    std::string name;
    std::function<double(std::size_t)> ask;  ///< the sample's distance; below 0: nothing
    using Times = std::vector<double>;       ///< ns a query, one a round
    Times cold{}, warm{};
    std::size_t hits = 0;
};

double median(std::vector<double> of) {
    std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2), of.end());
    return of[of.size() / 2];
}

/// Of the ratios of what was measured in the same round.
double median_ratio(const Contender::Times& a, const Contender::Times& b) {
    std::vector<double> ratios(a.size());
    std::transform(a.begin(), a.end(), b.begin(), ratios.begin(), std::divides<>());
    return median(ratios);
}

/// Contenders take turns, so that what else runs on the machine hits all of them. In a turn each asks all
/// samples twice over: first with its data pushed out of the caches by the others, then with what it left there
/// itself.
void race(const std::string& title, std::size_t samples, std::vector<Contender> all) {
    constexpr int kRounds = 25;
    double sum = 0;
    for (int round = 0; round < kRounds; ++round)
        for (Contender& each : all)
            for (Contender::Times* times : {&each.cold, &each.warm}) {
                each.hits = 0;
                const double start = thread_seconds();
                for (std::size_t i = 0; i < samples; ++i) {
                    const double distance = each.ask(i);
                    each.hits += distance >= 0;
                    sum += distance;
                }
                times->push_back(1e9 * (thread_seconds() - start) / static_cast<double>(samples));
            }
    fmt::print("\n{}: {} queries (checksum {:.6g})\n", title, samples, sum);
    fmt::print("  {:<24} {:>16} {:>16}   first is so many times as fast\n", "", "warm ns", "cold ns");
    for (const Contender& each : all)
        fmt::print("  {:<24} {:16.1f} {:16.1f}   {:6} hits  {:6.2f} warm {:6.2f} cold\n", each.name,
                   median(each.warm), median(each.cold), each.hits, median_ratio(each.warm, all.front().warm),
                   median_ratio(each.cold, all.front().cold));
}

double answer(const SurfaceHit& hit) { return hit.answer == Answer::found ? hit.distance : -1; }

}  // namespace

int main() {
    const test::WalkSamples s(ORBWEAVER_MESHES "/stanford-bunny.obj");
    const FclTree fcl(s.set);
    const Embree fast(s.set, RTC_SCENE_FLAG_NONE);
    const Embree robust(s.set, RTC_SCENE_FLAG_ROBUST);
    const Bullet bullet(s.set);
    fmt::print("bunny, {} triangles; Embree {} is Debian's, with its assertions compiled in\n",
               s.set.triangles.size(), RTC_VERSION_STRING);
    const auto rays = [&](const std::vector<SurfaceRay>& of) {
        return std::vector<Contender>{
            {"wide tree", [&](std::size_t i) { return answer(first_hit(*s.parts.tree(), s.set, of[i])); }},
            {"FCL's tree", [&](std::size_t i) { return answer(fcl.first_hit(of[i])); }},
            {"Embree", [&](std::size_t i) { return fast.first_hit(of[i]); }},
            {"Embree, robust", [&](std::size_t i) { return robust.first_hit(of[i]); }},
            {"Bullet", [&](std::size_t i) { return bullet.first_hit(of[i], 10 * s.size); }}};
    };
    std::vector<Contender> walkers = rays(s.short_rays);
    walkers.insert(walkers.begin(), {"underfoot", [&](std::size_t i) {
                                         return answer(underfoot(s.mesh, s.parts, s.stances[i]).hit);
                                     }});
    race("which polygon is underfoot, along a walk", s.stances.size(), walkers);
    // The same rays in another order: none begins near the one before.
    std::vector<SurfaceRay> scattered;
    for (std::size_t i = 0; i < s.short_rays.size(); ++i)
        scattered.push_back(s.short_rays[i * 7919 % s.short_rays.size()]);
    race("single short rays", scattered.size(), rays(scattered));
    race("rays across the mesh", s.long_rays.size(), rays(s.long_rays));
}
