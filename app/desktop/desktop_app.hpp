// The window's frame: input, simulation, picture, menus, telemetry.
#pragma once

#include "app/desktop/background_steps.hpp"
#include "app/desktop/desktop.hpp"
#include "app/desktop/desktop_actions.hpp"
#include "app/desktop/desktop_headset.hpp"
#include "app/desktop/desktop_lessons.hpp"
#include "app/desktop/desktop_menus.hpp"
#include "app/desktop/desktop_settings.hpp"
#include "app/desktop/desktop_sound.hpp"
#include "app/desktop/desktop_welders.hpp"
#include "app/desktop/detail_choice.hpp"
#include "app/desktop/frame_clock.hpp"
#include "app/desktop/frame_pacer.hpp"
#include "app/desktop/interface.hpp"
#include "app/desktop/screenshot_taker.hpp"
#include "app/desktop/seat_requests.hpp"
#include "app/desktop/shader_watch.hpp"
#include "app/desktop/window.hpp"
#include "app/desktop/window_picture.hpp"
#include "app/desktop/window_sections.hpp"
#include "app/desktop/window_telemetry.hpp"
#include "app/session/gamepad_keys.hpp"
#include "app/session/home.hpp"
#include "app/session/lesson_session.hpp"
#include "app/session/messages.hpp"
#include "app/session/notices.hpp"
#include "app/ui/letters.hpp"

namespace meltpool {

class DesktopApp {
  public:
    /// Opens the window on the home page, or on the named lesson's first page.
    explicit DesktopApp(const DesktopOptions& options);
    ~DesktopApp();

    bool closing() const { return window_.closing(); }
    void frame();
    /// Ends the lesson and writes the settings file. Returns false, with a sentence on standard error, if something to
    /// be saved is lost.
    bool finish();

  private:
    void takeGhost();
    void takeLanguage();
    void takeUnits();
    void takeWelder();
    void runFrame();
    bool rests() const;
    ParameterSection* headsetSection();
    void handleKeys(const InputFrame& input);
    friend std::span<const DesktopAction> desktopActions();
    /// Runs the action that a button asks for, or the allowed action of the key; no-op without one. If it would end the
    /// other person's weld, a question comes first.
    void act(MenuRequest request, Seat seat = Seat::desk);
    void act(Key key);
    void perform(const DesktopAction& action, Seat seat);
    void settleQuestions();
    void togglePause();
    void switchDeskView();
    void goHome();
    void goBack();
    void openNext();
    void tryCure();
    void startWithDefaults();
    void replay();
    void weldBeside();
    void reset();
    void redo();
    void leave();
    void judge();
    void cut();
    void toggle(bool PanelState::*panel);
    void toggleViewOrSettings();
    void hidePanels();
    void toMenus();
    GamepadUse gamepadUse();
    bool keysChoose();
    void keepFromTorch(InputFrame& input);
    void start(void (LessonSession::*begin)(Controls&));
    void moveByKeys(const InputFrame& input);
    void answerByKeys(const InputFrame& input);
    void moveInAttempts(const InputFrame& input);
    void demonstrateByKeys(const InputFrame& input);
    void replayByKeys(const InputFrame& input);
    void goOnByKeys(const InputFrame& input);
    void showAll();
    void takeJudgement();
    bool finishJudging();
    void beginHeadset(double seconds);
    void drawHeadset(double seconds);
    void simulate(const InputFrame& input, double seconds);
    bool stepsBesidePicture() const;
    void finishSteps(double seconds);
    void tellLesson(double seconds);
    void preparePicture(double seconds);
    void drawPicture();
    void show();
    bool mayStandStill() const;
    MenuRequest drawMenus();
    void tellMissingLetters();
    void writeTelemetry();

    DesktopOptions options_;
    FrameClock clock_;
    WindowTelemetry telemetry_;
    Messages messages_;
    Controls controls_;
    LessonFigures figures_;
    Notices notices_;

    Window window_;
    ui::Interface interface_;
    DesktopMenus menus_;
    gl::ShaderLibrary shaders_;
    BackgroundSteps steps_;
    Home home_;
    LessonSession session_;
    SeatRequests seats_{session_, messages_};
    DesktopSound sound_;
    DesktopHeadset headset_;
    gl::Profiler profiler_;
    WindowSections sections_;

    DesktopSettings settings_;
    DesktopLessons lessons_;
    DesktopWelders welders_;
    ShaderWatch shaderWatch_;
    FramePacer pacer_;
    WindowPicture picture_;
    DetailChoice detail_;
    ui::MissingLetters missingLetters_;
    ScreenshotTaker screenshots_;
    std::string driver_;
    size_t judgements_ = 0; ///< number of judgements that the menus have shown
};

} // namespace meltpool
