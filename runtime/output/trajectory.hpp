#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/npy.hpp"
#include "run/session.hpp"

namespace orbweaver {

/// Writes every recorded state array of a run: one "<instance>.<array>.npy" (frames x count [x 3]), time.npy,
/// and trajectory.json that says what each means. The first row is the state before the first frame.
class Trajectory {
public:
    Trajectory(const Session& session, const std::string& directory);

    void record();
    /// Leaves no file when a record() failed: some quantities would end before the others.
    void commit();
    bool whole() const noexcept { return whole_; }

private:
    struct Track {
        std::unique_ptr<NpyWriter> file;
        const StateBlock::Entry* entry = nullptr;
        std::string name;
    };

    std::string meaning() const;

    const Session& session_;
    NpyWriter time_;
    AtomicFile meaning_;
    std::vector<Track> tracks_;
    bool whole_ = true;
};

}  // namespace orbweaver
