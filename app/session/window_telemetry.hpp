// What the window tells a test or an observer: one JSON object a line, the newest last.
#pragma once

#include "app/meter/frame_meter.hpp"
#include "app/session/controls.hpp"
#include "app/session/messages.hpp"
#include "app/session/ui/panels.hpp"
#include "core/weld/torch/torch_sample.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace meltpool {

/// What happens at the tip of the torch in the hand, and what the hand feels.
struct TipTold {
    std::string action = "idle"; ///< "burning", "shorting", "stubbed", "breaking"
    double aheadMm = 0;          ///< to the metal along the torch's axis; infinite (null): none
    double nearestMm = 0;
    double liquid = 0;
    bool touching = false;
    double amplitude = 0;
    double frequency = 0;
    unsigned touches = 0; ///< since the start
    unsigned pulses = 0;  ///< sent to the controller since the headset was opened
};

/// What the headset does; as at first where none is looked for.
struct HeadsetTold {
    std::string state = "off"; ///< "searching", "asleep", "running", "stalled", "ended"
    std::string mode; ///< of the session: "waiting", "synchronized", "visible", "focused"; empty: there is none
    std::string warning;
    std::string tipReport; ///< what measuring the torch's tip wants or has found
    bool mirrored = false; ///< the window shows the trainee's eye
    int openings = 0;
    bool tracked = false; ///< the torch's hand
    bool panel = false;
    TipTold tip;
    double busyMs = 0;                       ///< CPU time of the last headset frame without the runtime's waiting
    std::map<std::string, ui::Place> places; ///< controls on the panel, its pixels
};

/// Everything a row is made of; borrowed for the call.
struct TelemetryRow {
    std::string page; ///< "start" or "running"
    double seconds = 0;
    long long frame = 0;
    size_t steps = 0;  ///< simulation steps since the start or the last reset
    TorchSample torch; ///< of the last step
    const Controls& controls;
    const ui::PanelState& panels;
    const ui::Figures& figures;
    const std::vector<const ui::Section*>& sections;
    const std::vector<std::string>& passes; ///< names of the timed GPU passes
    const Messages& messages;
    const ui::Context& context;
    glm::ivec2 size{0};     ///< window, points
    glm::ivec2 pixels{0};   ///< frame buffer
    std::string screenshot; ///< the last picture saved
    HeadsetTold headset;
    const FrameMeter& meter; ///< what the frames before this row cost
};

class WindowTelemetry {
  public:
    /// Throws InputError when the file cannot be written. An empty name writes nothing.
    explicit WindowTelemetry(const std::filesystem::path& file);

    bool enabled() const { return file_.is_open(); }
    /// True when it is time for another row: at most 20 a second.
    bool due(double now);
    void write(const TelemetryRow& row);

  private:
    std::ofstream file_;
    double next_ = 0;
};

} // namespace meltpool
