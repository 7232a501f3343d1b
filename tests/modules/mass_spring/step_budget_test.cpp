#include "step_budget.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver::mass_spring;

TEST_CASE("a budget grants as many steps as it has, and tells when one was refused", "[unit]") {
    StepBudget budget(3);
    for (int i = 0; i < 3; ++i) CHECK(budget.take());
    CHECK_FALSE(budget.refused());
    CHECK_FALSE(budget.take());
    CHECK(budget.refused());
    CHECK_FALSE(budget.stopped());
    CHECK(budget.taken() == 3);
}

TEST_CASE("once a stop is asked a budget grants nothing any more", "[unit]") {
    int asked = 0;
    StepBudget budget(100, [&] { return ++asked == 3; });
    CHECK((budget.take() && budget.take()));
    CHECK_FALSE(budget.take());
    CHECK_FALSE(budget.take());
    CHECK((budget.refused() && budget.stopped()));
    CHECK(budget.taken() == 2);
}

TEST_CASE("a budget without end refuses nothing", "[unit]") {
    StepBudget budget;
    for (int i = 0; i < 1000; ++i) budget.take();
    CHECK(budget.taken() == 1000);
    CHECK_FALSE(budget.refused());
}
