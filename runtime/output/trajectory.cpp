#include "output/trajectory.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace orbweaver {

Trajectory::Trajectory(const Session& session, const std::string& directory)
    : session_(session), time_(directory + "/time.npy", "<f8", {}), meaning_(directory + "/trajectory.json") {
    for (const auto& instance : session.instances())
        for (const StateBlock::Entry& entry : instance->block().entries()) {
            if (!entry.info.record) continue;
            const std::string name = instance->instance_name() + "." + entry.name;
            const bool vectors = std::holds_alternative<std::vector<Vec3>>(entry.data);
            const bool words = std::holds_alternative<std::vector<std::uint64_t>>(entry.data);
            std::vector<std::size_t> shape{entry.count()};
            if (vectors) shape.push_back(3);
            auto file = std::make_unique<NpyWriter>(fmt::format("{}/{}.npy", directory, name),
                                                    words ? "<u8" : "<f8", shape);
            tracks_.push_back({std::move(file), &entry, name});
        }
}

void Trajectory::record() {
    whole_ = false;
    const double time = session_.time();
    time_.append(&time, sizeof time);
    for (const Track& track : tracks_) track.file->append(track.entry->memory(), track.entry->bytes());
    whole_ = true;
}

std::string Trajectory::meaning() const {
    nlohmann::ordered_json json;
    json["scene"] = session_.scene().name;
    json["frame_step_s"] = session_.scene().step;
    json["quantities"]["time"] = {{"file", "time.npy"},
                                  {"shape", {time_.rows()}},
                                  {"unit", "s"},
                                  {"meaning", "time of each row; the first is before the first frame"}};
    for (const Track& track : tracks_) {
        std::vector<std::size_t> shape{track.file->rows(), track.entry->count()};
        if (std::holds_alternative<std::vector<Vec3>>(track.entry->data)) shape.push_back(3);
        json["quantities"][track.name] = {{"file", track.name + ".npy"},
                                          {"shape", shape},
                                          {"unit", track.entry->info.unit},
                                          {"meaning", track.entry->info.meaning}};
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void Trajectory::commit() {
    if (!whole_) return;
    meaning_.write(meaning());
    time_.commit();
    for (const Track& track : tracks_) track.file->commit();
    meaning_.commit();
}

}  // namespace orbweaver
