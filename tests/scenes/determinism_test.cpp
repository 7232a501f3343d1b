#include <catch2/catch.hpp>

#include "run/snapshot.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

constexpr int kFrames = 40;

std::uint64_t hash_after(OpenScene& scene, int frames) {
    for (int i = 0; i < frames; ++i) scene.session->step();
    return scene.session->state_hash();
}

}  // namespace

TEST_CASE("every shipped scene gives the same state on every run, on 1 and 2 threads", "[scene]") {
    const std::string name = GENERATE(from_range(shipped_scenes()));
    CAPTURE(name);
    OpenScene first = open_scene(name);
    const std::uint64_t expected = hash_after(first, kFrames);

    OpenScene again = open_scene(name);
    CHECK(hash_after(again, kFrames) == expected);

    Request two;
    two.threads = 2;
    OpenScene threaded = open_scene(name, two);
    CHECK(hash_after(threaded, kFrames) == expected);
}

TEST_CASE("a restored snapshot goes on to the state of the run that never stopped", "[scene]") {
    const std::string name = GENERATE(from_range(shipped_scenes()));
    CAPTURE(name);
    OpenScene whole = open_scene(name);
    hash_after(whole, 23);
    const std::string snapshot = save_snapshot(*whole.session);
    const std::uint64_t expected = hash_after(whole, 77);

    OpenScene resumed = open_scene(name);
    restore_snapshot(*resumed.session, snapshot, "the snapshot");
    CHECK(hash_after(resumed, 77) == expected);
}

TEST_CASE("another seed gives another web", "[scene]") {
    OpenScene one = open_scene("meadow");
    OpenScene other = open_scene("meadow", {}, {"scene.seed=12345"});
    CHECK(hash_after(one, 5) != hash_after(other, 5));
}
