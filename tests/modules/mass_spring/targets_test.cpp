#include "orbweaver/targets.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "spring_kernel.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("the processor's widest vectors are used, and none where the environment says so", "[unit]") {
    if (std::getenv("ORBWEAVER_PLAIN") == nullptr) {
        CHECK(wide_vectors_allowed());
        const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
        const std::string plain = "ORBWEAVER_PLAIN=1 '" + self + "' 'the processor*' -w NoTests > /dev/null";
        CHECK(std::system(plain.c_str()) == 0);
        return;
    }
    CHECK_FALSE(has_avx2());
    CHECK_FALSE(has_avx512());
    CHECK(wide_kernels() == nullptr);
    CHECK(&best_kernels() == &plain_kernels());
}
