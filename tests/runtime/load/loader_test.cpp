#include "load/loader.hpp"

#include <catch2/catch.hpp>

#include "output/loaded_libraries.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

Manifest fixture_manifest(const std::string& name) {
    Catalog catalog = read_catalog({fixture(name)});
    REQUIRE(sentences(catalog.faults) == std::vector<std::string>{});
    REQUIRE(catalog.manifests.size() == 1);
    return std::move(catalog.manifests.front());
}

bool is_mapped(const std::string& library) {
    const auto all = loaded_libraries();
    return std::find(all.begin(), all.end(), library) != all.end();
}

struct Broken {
    const char* name;
    LoadFault fault;
    std::string sentence;  ///< behind "module '<name>': "
};

std::vector<Broken> broken_modules() {
    const auto file = [](const std::string& name, const char* kind) {
        return fixture(name) + "/" + name + kind;
    };
    return {
        {"missing_library", LoadFault::no_file,
         "its library " + file("missing_library", ".so") + " is not there; build it, or remove " +
             file("missing_library", ".toml")},
        {"text_file", LoadFault::not_a_library,
         file("text_file", ".so") +
             " is not a shared library; expected an ELF shared object; build the module again"},
        {"cut_header", LoadFault::not_a_library,
         file("cut_header", ".so") +
             " is not a shared library; expected an ELF shared object; build the module again"},
        {"cut_segments", LoadFault::not_a_library,
         file("cut_segments", ".so") + " ends too early, after 4096 bytes; build the module again"},
        {"missing_dependency", LoadFault::cannot_open,
         "the system's loader refuses it: libfixture_absent.so: cannot open shared object file: No such file "
         "or "
         "directory; install what is missing"},
        {"no_entry", LoadFault::no_entry,
         file("no_entry", ".so") +
             " has no entry point orbweaver_module; end the module with ORBWEAVER_MODULE(...)"},
        {"wrong_abi", LoadFault::wrong_abi,
         file("wrong_abi", ".so") + " speaks ABI version " + std::to_string(kAbiVersion + 1) +
             " and this program version " + std::to_string(kAbiVersion) +
             "; build the module against this program's SDK"},
        {"wrong_build", LoadFault::wrong_build,
         file("wrong_build", ".so") +
             " was built with \"sdk of last year, some compiler\" and this program with \"" + kBuildStamp +
             "\"; build both from the same headers with the same compiler"},
        {"manifest_mismatch", LoadFault::manifest_mismatch,
         "line 2 of " + file("manifest_mismatch", ".toml") +
             " is `version = \"2\"`, but the module was built with `version = \"1\"`; build the module again, "
             "or "
             "restore its manifest"},
    };
}

}  // namespace

TEST_CASE("each way in which a module can fail to load has its own name and sentence", "[extreme]") {
    for (const Broken& broken : broken_modules()) {
        CAPTURE(broken.name);
        const Manifest manifest = fixture_manifest(broken.name);
        try {
            const LoadedModule module(manifest);
            FAIL("it was loaded");
        } catch (const LoadError& error) {
            CHECK(error.what() == "module '" + std::string(broken.name) + "': " + broken.sentence);
            CHECK(error.fault() == broken.fault);
            CHECK(error.kind() == FaultKind::invalid);
        }
        CHECK_FALSE(is_mapped(manifest.library));
    }
}

TEST_CASE("a module that cannot be loaded ends the program with code 3 and the same sentence", "[extreme]") {
    const Folder folder;
    for (const Broken& broken : broken_modules()) {
        CAPTURE(broken.name);
        const std::string scene = folder.write("scene.toml", "[" + std::string(broken.name) + "]\n");
        for (const char* command : {"run", "check"}) {
            const Outcome outcome = run_program({command, scene, "--modules", fixture(broken.name)});
            CHECK(outcome.code == 3);
            CHECK(outcome.err == "error: module '" + std::string(broken.name) + "': " + broken.sentence + "\n");
        }
    }
}

TEST_CASE("a good module is opened once, and gone with its last owner", "[unit]") {
    const Manifest manifest = fixture_manifest("counter");
    REQUIRE_FALSE(is_mapped(manifest.library));
    {
        const LoadedModule module(manifest);
        CHECK(is_mapped(manifest.library));
        CHECK(module.descriptor().abi_version == kAbiVersion);
        CHECK(module.descriptor().manifest == manifest.text);
    }
    CHECK_FALSE(is_mapped(manifest.library));
}

TEST_CASE("a manifest that goes on where the built one ended is a mismatch, and the other way round",
          "[unit]") {
    Manifest manifest = fixture_manifest("diverges");
    const std::string whole = manifest.text;
    const std::string where = " of " + manifest.path + " is ";
    manifest.text = whole + "needs = []\n";
    CHECK_THAT(fault_of([&] { const LoadedModule module(manifest); }),
               Catch::Contains(where + "`needs = []`, but the module was built with `(its end)`"));
    manifest.text = whole.substr(0, whole.find("phases"));
    CHECK_THAT(
        fault_of([&] { const LoadedModule module(manifest); }),
        Catch::Contains(where + "`(its end)`, but the module was built with `phases = [\"integrate\"]`"));
}
