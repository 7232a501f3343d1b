#pragma once

namespace orbweaver {

/// What a person did since the last poll.
struct InputEvents {
    bool quit = false;
    bool toggle_pause = false;
    int steps = 0;       ///< single frames asked for while paused
    bool reset = false;  ///< back to the first frame
    bool reset_camera = false;
    double orbit_x = 0;  ///< fraction of the window's width dragged, right positive
    double orbit_y = 0;  ///< fraction of the window's height dragged, up positive
    double zoom = 0;     ///< wheel notches, towards positive
    bool help = false;   ///< print the list of keys
    int walk = 0;        ///< keys that are held: 1 forward, -1 back
    int turn = 0;        ///< the same: 1 to the left, -1 to the right
};

/// Keys and mouse of a window.
class Input {
public:
    static constexpr const char* kContract = "input/1";

    /// Polled once a picture by the host; `latest()` then gives the same events to whoever draws.
    virtual const InputEvents& poll() noexcept = 0;
    virtual const InputEvents& latest() const noexcept = 0;
    /// The list of keys, one a line, for the terminal.
    virtual const char* key_list() const noexcept = 0;

protected:
    ~Input() = default;
};

}  // namespace orbweaver
