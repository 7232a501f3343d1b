#include <variant>

#include "manifest_text.hpp"
#include "orbweaver/entry.hpp"
#include "wind_models.hpp"

namespace orbweaver::wind {

/// The [wind] table: offers the one model it asks for. Stateless, so there is nothing to run.
class WindModule final : public Module {
public:
    void attach(Host& host) override {
        choose_model(host);
        std::visit([&](WindField& model) { host.provide<WindField>(model); }, model_);
    }

    void run(Phase, const Frame&) override {}

private:
    void choose_model(Host& host) {
        const Options& options = host.options();
        const std::string& name = options.text("model");
        if (name == "thesis") {
            model_ = ThesisWind(options.number("strength"), options.number("degrees_per_second"),
                                host.random("direction"));
        } else if (name == "steady" && options.has("velocity")) {
            model_ = SteadyWind(options.vector("velocity"));
        } else if (name == "steady") {
            host.report_fault({options.where("model"), "a steady wind has no velocity",
                               "velocity = [x, y, z] in m/s", "add 'velocity' to [wind]"});
        }
    }

    std::variant<CalmWind, SteadyWind, ThesisWind> model_;
};

}  // namespace orbweaver::wind

ORBWEAVER_MODULE(orbweaver::wind::WindModule)
