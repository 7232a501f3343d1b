#pragma once

#include <spdlog/spdlog.h>

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "run/session.hpp"
#include "scene/toml_reader.hpp"
#include "support/program.hpp"

namespace orbweaver::test {

/// The sentence of the Fault that a call ends in; fails the test when there is none.
template <class Call>
std::string fault_of(Call&& call) {
    try {
        call();
    } catch (const Fault& fault) {
        return fault.what();
    }
    FAIL("no Fault was thrown");
    return {};
}

template <class Call>
FaultKind kind_of_fault(Call&& call) {
    try {
        call();
    } catch (const Fault& fault) {
        return fault.kind();
    }
    FAIL("no Fault was thrown");
    return {};
}

inline std::vector<std::string> sentences(const Diagnostics& faults) {
    std::vector<std::string> all;
    for (const Diagnostic& fault : faults) all.push_back(to_string(fault));
    return all;
}

/// A scene given as text, planned and opened with the named test modules.
struct OpenedScene {
    Catalog catalog;
    Request request;
    Plan plan;
    std::unique_ptr<Session> session;

    OpenedScene(const std::string& text, const std::vector<std::string>& fixtures, Request asked = {})
        : request(std::move(asked)) {
        spdlog::set_level(spdlog::level::warn);
        std::vector<std::string> folders;
        for (const std::string& name : fixtures) folders.push_back(fixture(name));
        catalog = read_catalog(folders);
        plan = make_plan(read_toml_text(text, "scene.toml"), "scene.toml", catalog, request);
        REQUIRE(sentences(plan.faults) == std::vector<std::string>{});
        session = std::make_unique<Session>(plan, request);
    }

    void run(int frames) const {
        for (int i = 0; i < frames; ++i) session->step();
    }
};

}  // namespace orbweaver::test
