#include "run/snapshot.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

constexpr const char* kScene = "[scene]\nseed = 3\n[[counter]]\n[[counter]]\nmode = \"down\"\nstart = 100\n";

struct Refused {
    const char* name;
    std::string bytes;
    std::string sentence;
};

std::string patched(std::string bytes, std::size_t at, std::uint32_t word) {
    std::memcpy(bytes.data() + at, &word, sizeof word);
    return bytes;
}

}  // namespace

TEST_CASE("a restored session goes on to the hash of the one that never stopped", "[unit]") {
    const OpenedScene whole(kScene, {"counter"});
    whole.run(23);
    const std::string snapshot = save_snapshot(*whole.session);
    const std::uint64_t there = whole.session->state_hash();
    whole.run(77);

    const OpenedScene resumed(kScene, {"counter"});
    restore_snapshot(*resumed.session, snapshot, "the snapshot");
    CHECK(resumed.session->frame() == 23);
    CHECK(resumed.session->state_hash() == there);
    resumed.run(77);
    CHECK(resumed.session->state_hash() == whole.session->state_hash());
    CHECK(save_snapshot(*resumed.session) == save_snapshot(*whole.session));
}

TEST_CASE("restoring rebuilds what modules derive from their state", "[unit]") {
    const OpenedScene whole(kScene, {"counter"});
    whole.run(9);
    const OpenedScene resumed(kScene, {"counter"});
    restore_snapshot(*resumed.session, save_snapshot(*whole.session), "the snapshot");
    const auto x = [](const OpenedScene& scene) {
        return scene.session->instances().front()->telemetry_columns().front().value();
    };
    CHECK(x(whole) != 0);
    CHECK(x(resumed) == x(whole));
}

TEST_CASE("a snapshot that does not fit is refused in words and leaves the session as it was", "[extreme]") {
    const OpenedScene saved(kScene, {"counter"});
    saved.run(5);
    const std::string good = save_snapshot(*saved.session);
    const OpenedScene one("[counter]\n", {"counter"});
    const OpenedScene other("[diverges]\n", {"diverges"});
    const OpenedScene three(std::string(kScene) + "[[counter]]\n", {"counter"});
    const OpenedScene slower("[scene]\nstep = 0.25\n[[counter]]\n[[counter]]\n", {"counter"});
    constexpr const char* kDamaged = "s: the snapshot is damaged: its checksum does not match; save it again";
    constexpr const char* kForeign = "s: this is not a snapshot; expected a file that --save-state wrote";
    const Refused cases[] = {
        {"empty", "", kForeign},
        {"text", std::string(1000, 'x'), kForeign},
        {"cut in its header", good.substr(0, 20), kForeign},
        {"cut at the end", good.substr(0, good.size() - 1), kDamaged},
        {"cut behind its header", good.substr(0, 56), kDamaged},
        {"longer", good + "x", kDamaged},
        {"another version", patched(good, 8, 1),
         "s: the snapshot has version 1 and byte order 01020304; expected 2 and 01020304; save it again with "
         "this program"},
        {"another byte order", patched(good, 12, 0x04030201),
         "s: the snapshot has version 2 and byte order 04030201; expected 2 and 01020304; save it again with "
         "this program"},
        {"frames of another length", save_snapshot(*slower.session),
         "s: the snapshot was saved in frames of 0.25 s and this run's are of 0.016666666666666666 s; run with "
         "--step 0.25"},
        {"fewer arrays", save_snapshot(*one.session),
         "s: the snapshot has (nothing more) of 0 bytes where this scene has counter.2/count of 8; restore it "
         "into the "
         "scene that saved it"},
        {"more arrays", save_snapshot(*three.session),
         "s: the snapshot has 9 arrays and this scene 6; restore it into the scene that saved it"},
        {"another scene", save_snapshot(*other.session),
         "s: the snapshot has diverges/value of 8 bytes where this scene has counter/count of 8; restore it "
         "into the "
         "scene that saved it"},
    };
    const OpenedScene opened(kScene, {"counter"});
    opened.run(2);
    const std::string before = save_snapshot(*opened.session);
    for (const Refused& refused : cases) {
        CAPTURE(refused.name);
        const auto restore = [&] { restore_snapshot(*opened.session, refused.bytes, "s"); };
        CHECK(fault_of(restore) == refused.sentence);
        CHECK(kind_of_fault(restore) == FaultKind::invalid);
        CHECK(save_snapshot(*opened.session) == before);
    }
}

TEST_CASE("a snapshot knows the seed and the options that it was saved with", "[unit]") {
    const OpenedScene saved(kScene, {"counter"});
    const std::string bytes = save_snapshot(*saved.session);
    const std::string rest = std::strchr(kScene, '[') + std::strlen("[scene]\nseed = 3\n");
    const auto same_setup = [&](const std::string& scene) {
        const OpenedScene opened(scene, {"counter"});
        return restore_snapshot(*opened.session, bytes, "s");
    };
    CHECK(same_setup(kScene));
    CHECK(same_setup("[scene]\nseed = 3\nduration = 99\nname = \"other\"\n" + rest));
    CHECK_FALSE(same_setup("[scene]\nseed = 4\n" + rest));
    CHECK_FALSE(same_setup("[scene]\nseed = 3\ngravity = [0, 0, 0]\n" + rest));
    CHECK_FALSE(same_setup(std::string(kScene) + "stride = 0.7\n"));
}

TEST_CASE("no byte of a snapshot can change unnoticed, and none can be missing", "[extreme]") {
    const OpenedScene opened(kScene, {"counter"});
    opened.run(5);
    const std::string good = save_snapshot(*opened.session);
    int unnoticed = 0;
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string damaged = good;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        for (const std::string& bytes : {damaged, good.substr(0, i)}) {
            try {
                restore_snapshot(*opened.session, bytes, "s");
                ++unnoticed;
            } catch (const Fault&) {
            }
        }
    }
    CHECK(unnoticed == 0);
    CHECK(save_snapshot(*opened.session) == good);
}

TEST_CASE("snapshots go through files", "[unit]") {
    const Folder folder;
    const OpenedScene saved(kScene, {"counter"});
    saved.run(5);
    folder.write("state", save_snapshot(*saved.session));
    const OpenedScene opened(kScene, {"counter"});
    read_snapshot_file(*opened.session, folder.path("state"));
    CHECK(opened.session->state_hash() == saved.session->state_hash());
    REQUIRE(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
    for (const std::string& path : {folder.path("none"), folder.path(), folder.path("pipe")})
        CHECK(fault_of([&] { read_snapshot_file(*opened.session, path); }) ==
              path + ": this is no file; expected a snapshot that --save-state wrote");
}
