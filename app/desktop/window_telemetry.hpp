// Writes the state of the window for tests and observers: a file with one JSON object a line, the newest last.
#pragma once

#include "app/activities/activities.hpp"
#include "app/activities/attempt_judge.hpp"
#include "app/platform/frame_meter.hpp"
#include "app/session/controls.hpp"
#include "app/session/cut_view.hpp"
#include "app/session/headset_status.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/menu_state.hpp"
#include "app/session/messages.hpp"
#include "app/ui/widgets.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace meltpool {

/// Content of a row; borrowed for the call.
struct TelemetryRow {
    std::string page; ///< "home", "start" or "running"
    double seconds = 0;
    long long frame = 0;
    size_t steps = 0;  ///< simulation steps since the start or the last reset
    TorchSample torch; ///< torch of the last step
    const Controls& controls;
    const PanelState& panels;
    const LessonFigures& figures;
    const std::vector<const ParameterSection*>& sections;
    const std::vector<std::string>& passes; ///< names of the timed GPU passes
    const Messages& messages;
    const ui::Context& context;
    glm::ivec2 size{0};                         ///< size of the window, points
    glm::ivec2 pixels{0};                       ///< size of the frame buffer
    std::string screenshot;                     ///< file of the last saved picture
    bool stepsBeside = false;                   ///< another thread made the last frame's steps
    const std::optional<JudgedAttempt>& judged; ///< judgement of the attempt
    const Activities& activities;
    const CutView& cut;
    HeadsetStatus headset;
};

class WindowTelemetry {
  public:
    /// Throws InputError if the file cannot be written. An empty name writes nothing.
    explicit WindowTelemetry(const std::filesystem::path& file);

    bool enabled() const { return file_.is_open(); }
    /// Reason why the telemetry ended before the program, as a sentence; empty while it is complete or disabled.
    const std::string& fault() const { return fault_; }

    /// Counts allocations, stalls and the driver's time too, if telemetry is enabled and call counters are loaded. Call
    /// once OpenGL's functions are loaded.
    void countCalls();
    /// Begins the processor's costs of a frame, which end at endFrame().
    void beginFrame() { meter_.begin(); }
    /// Ends the costs of a frame. `beside`: costs of other threads' work for the frame. `another`: the next frames are
    /// of another kind, with a headset or without; forgets the costs of the frames so far.
    void endFrame(const WorkCosts& beside, bool another);

    /// Returns true when another row is due: at most 20 a second. The frame's costs do not count from here to write(),
    /// which must follow.
    bool due(double now);
    /// Adds a row. The first row that the disk refuses ends the telemetry and sets fault(); the window continues.
    void write(const TelemetryRow& row);

  private:
    void writeLine(const TelemetryRow& row);

    std::filesystem::path name_;
    std::ofstream file_;
    std::string fault_;
    double next_ = 0;
    FrameMeter meter_;          ///< costs of the frames before a row
    bool callsCounted_ = false; ///< the meter counts allocations, stalls and the driver
};

} // namespace meltpool
