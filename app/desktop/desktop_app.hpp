// The window's frame: input, simulation, picture, interface, and what is told and kept.
#pragma once

#include "app/desktop/desktop.hpp"
#include "app/desktop/interface.hpp"
#include "app/desktop/window.hpp"
#include "app/desktop/window_telemetry.hpp"
#include "app/headset/headset_front_end.hpp"
#include "app/program/frame_meter.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"
#include "app/session/settings.hpp"

#include <chrono>
#include <optional>

namespace meltpool {

/// What the window itself remembers.
struct WindowParameters {
    int width = 1280; ///< screen points
    int height = 720; ///< screen points
    bool maximised = false;
    float interfaceSize = 1; ///< factor on what the desktop asks for
};
ParameterList describe(WindowParameters& parameters);

class DesktopApp {
  public:
    /// Opens the window on the start menu.
    explicit DesktopApp(const DesktopOptions& options);

    bool closing() const { return window_.closing(); }
    void frame();
    /// What the frames cost; measured where telemetry is asked for.
    const FrameMeter& meter() const { return meter_; }
    /// Keeps the settings; what fails is said on standard error.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;

    void runFrame();
    void readSettings();
    std::vector<SettingsSection> settingsSections();
    void handleKeys(const InputFrame& input);
    void act(MenuRequest request);
    void startLesson();
    void beginHeadset(double seconds);
    void drawHeadset(double seconds);
    void simulate(const InputFrame& input, double seconds);
    void drawPicture(double seconds);
    float coveredLeft();
    float coveredRight();
    MenuRequest drawInterface();
    MenuRequest drawPanels();
    void makeRoom();
    void watchShaders();
    void countFrame(double seconds);
    void pace(Clock::time_point begin) const;
    void takePicture();
    void tellTelemetry();
    double now() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

    DesktopOptions options_;
    Clock::time_point begun_ = Clock::now();
    WindowTelemetry telemetry_;
    Messages messages_;
    WindowParameters windowParameters_;
    PanelState panels_;
    Controls controls_;
    LessonFigures figures_;

    Window window_;
    ui::Interface interface_;
    gl::ShaderLibrary shaders_;
    LessonSession session_;
    std::optional<HeadsetFrontEnd> headset_;
    gl::Profiler profiler_;
    FrameMeter meter_;
    bool callsCounted_ = false; ///< the meter knows of allocations, stalls and the driver
    /// Where the kept values of the ordinary lesson live while another one runs.
    std::optional<Lesson> keptLesson_;
    std::optional<LessonSections> keptSections_;
    ParameterSection windowSection_;
    ParameterSection controlSection_;
    ParameterSection panelSection_;

    std::filesystem::path settingsFile_;
    std::string screenshot_;
    std::string driver_;
    bool pictureAsked_ = false;
    bool timingsAreNewer_ = false; ///< if both panels at the left are open in the next frame
    bool headsetFrame_ = false;    ///< the headset paces this frame
    bool headsetStarted_ = false;  ///< the lesson was begun for it
    double lastFrame_ = 0;
    double frameSeconds_ = 0;
    double nextShaderLook_ = 0;
    float shift_ = 0; ///< of the picture's middle, where panels cover a part of the window
    long long frames_ = 0;
};

} // namespace meltpool
