#include "app/desktop/desktop_app.hpp"

#include "app/desktop/screenshot.hpp"
#include "app/program/call_counters.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"

#include <algorithm>
#include <cstdio>
#include <thread>

namespace meltpool {

namespace {

/// No display shows more, and a driver that does not wait for the display must not eat the processor.
constexpr double kShortestFrame = 1.0 / 125;
constexpr double kShaderLookEvery = 0.5;
constexpr double kPatienceMinimised = 0.1;
/// How long a headset that was asked for may take to appear, s.
constexpr double kHeadsetPatience = 15;

std::string driverText(const gl::ContextInfo& info) {
    return info.renderer + (info.software ? " \xE2\x80\x93 drawn on the processor, without a graphics card" : "");
}

} // namespace

ParameterList describe(WindowParameters& w) {
    return {
        {"width", "Width", "points", &w.width, 640, 16384, "of the window at the next start"},
        {"height", "Height", "points", &w.height, 480, 16384, "of the window at the next start"},
        {"maximised", "Maximised", "", &w.maximised, 0, 1, "at the next start"},
        {"interface_size", "Size of text and menus", "", &w.interfaceSize, 0.7, 2,
         "On top of what the desktop asks for; large menus cover more of the picture."},
    };
}

DesktopApp::DesktopApp(const DesktopOptions& options)
    : options_(options),
      telemetry_(options.telemetry),
      window_(Window::Options{}),
      interface_(window_),
      shaders_(resourceFolder() / "shaders"),
      session_(shaders_, loadLesson(options.lesson)),
      windowSection_("window", describe(windowParameters_)),
      controlSection_("controls", describe(controls_.parameters)),
      panelSection_("panels", describe(panels_)),
      settingsFile_(options.settings.empty() ? settingsFolder() / "settings.toml" : options.settings),
      driver_(driverText(window_.driver())) {
    if (options_.lesson != kDefaultLesson) {
        keptLesson_.emplace(loadLesson(std::string(kDefaultLesson)));
        keptSections_.emplace(*keptLesson_);
    }
    if (options_.headset != HeadsetUse::off) headset_.emplace(settingsFolder());
    session_.record(options_.record);
    if (telemetry_.enabled()) callsCounted_ = joinCallCounters();
    readSettings();
    window_.resize({windowParameters_.width, windowParameters_.height}, windowParameters_.maximised);
    window_.show();
    lastFrame_ = now();
}

std::vector<SettingsSection> DesktopApp::settingsSections() {
    LessonSections& lesson = keptSections_ ? *keptSections_ : session_.sections();
    std::vector<ParameterSection*> all = lesson.all();
    all.insert(all.end(), {&windowSection_, &controlSection_, &panelSection_});
    if (headset_) all.push_back(&headset_->section());
    std::vector<SettingsSection> sections;
    ParameterList kept;
    for (const ParameterSection* each : all) {
        sections.push_back({each->name, {}});
        for (const Parameter& p : each->parameters) {
            // A value that stands in two menus is kept once, where it was named first.
            const bool known =
                std::any_of(kept.begin(), kept.end(), [&p](const Parameter& k) { return k.value == p.value; });
            if (known) continue;
            kept.push_back(p);
            sections.back().parameters.push_back(p);
        }
    }
    return sections;
}

void DesktopApp::readSettings() {
    for (std::string& fault : loadSettings(settingsFile_, settingsSections()))
        messages_.warn(std::move(fault), now());
}

void DesktopApp::finish() {
    const glm::ivec2 size = window_.normalSize();
    windowParameters_.width = std::clamp(size.x, 640, 16384);
    windowParameters_.height = std::clamp(size.y, 480, 16384);
    windowParameters_.maximised = window_.maximised();
    try {
        saveSettings(settingsFile_, settingsSections());
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "the settings were not kept: %s\n", fault.what());
    }
}

void DesktopApp::frame() {
    if (!telemetry_.enabled()) return runFrame();
    const bool headset = headsetFrame_;
    meter_.begin();
    runFrame();
    meter_.end();
    if (headset != headsetFrame_) meter_.restart(); // frames of another kind begin
}

void DesktopApp::runFrame() {
    const Clock::time_point begin = Clock::now();
    InputFrame input = window_.poll(window_.minimised() && !headsetFrame_ ? kPatienceMinimised : 0);
    const double time = now();
    const double seconds = time - lastFrame_;
    lastFrame_ = time;
    beginHeadset(seconds);
    if (window_.minimised() && !headsetFrame_) return;

    messages_.expire(time);
    watchShaders();
    const bool captured = session_.running() && controls_.captured();
    interface_.begin(windowParameters_.interfaceSize, captured, !session_.running());
    interface_.takeInput(input, captured);
    handleKeys(input);
    const bool timed = panels_.timings && !panels_.hidden;
    if (timed) profiler_.beginFrame();
    simulate(input, seconds);
    drawHeadset(seconds);
    drawPicture(seconds);
    MenuRequest request = MenuRequest::none;
    {
        const gl::Scope scope(&profiler_, "interface");
        request = drawInterface();
        interface_.end();
    }
    if (timed) profiler_.endFrame();
    if (pictureAsked_) takePicture();
    countFrame(seconds);
    tellTelemetry();
    window_.swap();
    act(request);
    window_.captureMouse(session_.running() && controls_.captured());
    if (!headsetFrame_) pace(begin);
}

void DesktopApp::beginHeadset(double seconds) {
    headsetFrame_ = headset_ && headset_->begin(session_, seconds);
    if (!headset_) return;
    if (options_.headset == HeadsetUse::wanted && headset_->openings() == 0 && now() > kHeadsetPatience)
        throw InputError("there is no headset to use: " + headset_->sentence());
    window_.waitForDisplay(!headsetFrame_);
    if (headset_->warning().empty())
        messages_.clear("headset");
    else
        messages_.hold(headset_->warning(), "headset");
    // Whoever puts the headset on finds the metal on the table.
    if (headsetFrame_ && !headsetStarted_ && !session_.running()) startLesson();
    headsetStarted_ = headsetStarted_ || headsetFrame_;
}

void DesktopApp::drawHeadset(double seconds) {
    if (!headsetFrame_) return;
    const gl::Scope scope(&profiler_, "headset");
    const MenuRequest request = headset_->draw(session_, figures_, seconds, &profiler_);
    headset_->end();
    act(request);
}

void DesktopApp::handleKeys(const InputFrame& input) {
    for (const Key key : input.struck) {
        switch (key) {
        case Key::escape:
            panels_.help = false;
            break;
        case Key::tab:
            panels_.hidden = session_.running() && !panels_.hidden;
            break;
        case Key::f1:
            panels_.help = !panels_.help;
            break;
        case Key::f2:
            panels_.view = !panels_.view;
            break;
        case Key::f3:
            panels_.simulation = !panels_.simulation;
            break;
        case Key::f4:
            panels_.timings = !panels_.timings;
            break;
        case Key::f5:
            session_.reset(controls_);
            break;
        case Key::f11:
            window_.toggleFullScreen();
            break;
        case Key::f12:
            pictureAsked_ = true;
            messages_.clear("picture"); // the last picture's message is not for this one
            break;
        default:
            break;
        }
    }
}

void DesktopApp::act(MenuRequest request) {
    switch (request) {
    case MenuRequest::startWithDefaults:
        session_.sections().restoreDefaults();
        startLesson();
        break;
    case MenuRequest::start:
        startLesson();
        break;
    case MenuRequest::reset:
        session_.reset(controls_);
        break;
    case MenuRequest::restart:
        session_.end();
        controls_.restart();
        panels_.help = false;
        profiler_.reset();
        messages_.clear("metal");
        break;
    case MenuRequest::none:
        break;
    }
}

void DesktopApp::startLesson() {
    try {
        session_.begin(controls_);
        panels_.hidden = false;
        profiler_.reset();
    } catch (const std::exception& fault) {
        session_.end();
        messages_.warn(fault.what(), now(), "start");
    }
}

void DesktopApp::simulate(const InputFrame& input, double seconds) {
    if (!session_.running()) return;
    controls_.update(input, seconds);
    // The desk takes the torch over by catching the mouse.
    const TorchSource held = headsetFrame_ && !controls_.captured() ? headset_->torch() : TorchSource{};
    session_.advance(controls_, seconds, &profiler_, held);
    session_.fillFigures(figures_);
    if (!session_.fault().empty())
        messages_.hold("The simulation stands still: " + session_.fault() + ". Reset begins again.", "metal");
    else if (figures_.refused > 0)
        messages_.hold(
            "The metal became unstable: some particles got a state that is no number and kept their old one. "
            "A smaller time step, heat or stiffness helps; Reset begins again.",
            "metal");
    else
        messages_.clear("metal");
}

float DesktopApp::coveredLeft() {
    const int panels = static_cast<int>(panels_.view) + static_cast<int>(panels_.timings);
    return panels_.hidden ? 0 : static_cast<float>(panels) * ui::panelReach(interface_.context());
}

float DesktopApp::coveredRight() {
    return panels_.simulation && !panels_.hidden ? ui::panelReach(interface_.context()) : 0;
}

void DesktopApp::drawPicture(double seconds) {
    const glm::ivec2 pixels = window_.pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (session_.running()) {
        // The metal stays in the middle of what the panels leave free, and glides there.
        const float width = static_cast<float>(std::max(window_.size().x, 1));
        const float wanted = (coveredLeft() - coveredRight()) / width;
        if (headsetFrame_ && headset_->mirror(pixels)) return;
        shift_ += (wanted - shift_) * std::min(1.0f, static_cast<float>(seconds) * 10);
        session_.draw(controls_, pixels, shift_, &profiler_);
        return;
    }
    glViewport(0, 0, pixels.x, pixels.y);
    glClearColor(0.07f, 0.08f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

MenuRequest DesktopApp::drawInterface() {
    ui::Context& context = interface_.context();
    MenuRequest request = MenuRequest::none;
    if (!session_.running())
        request = ui::startMenu(context, session_.sections().start, session_.lesson().text, driver_);
    else if (!panels_.hidden)
        request = drawPanels();
    if (panels_.help) ui::helpOverlay(context, panels_.help);
    const bool running = session_.running();
    ui::messageStack(context, messages_, running ? coveredLeft() : 0, running ? coveredRight() : 0);
    return request;
}

MenuRequest DesktopApp::drawPanels() {
    ui::Context& context = interface_.context();
    const LessonSections& lesson = session_.sections();
    const MenuRequest request = ui::topBar(context, panels_, controls_, session_.lesson().title);
    ui::statusBar(context, figures_, controls_);
    ui::temperatureScale(context, session_.lesson().look.colours, session_.temperature(), coveredLeft());
    makeRoom();
    if (panels_.view) {
        const std::array<const ParameterSection*, 5> sections{&lesson.view, &lesson.surface, &controlSection_,
                                                              &windowSection_,
                                                              headset_ ? &headset_->section() : nullptr};
        ui::viewMenu(context, std::span(sections).first(headset_ ? 5 : 4));
    }
    if (panels_.simulation) ui::simulationMenu(context, lesson.simulation, controls_);
    if (panels_.timings) ui::timingsPanel(context, profiler_, figures_, frameSeconds_ * 1000, driver_, panels_.view);
    return request;
}

void DesktopApp::makeRoom() {
    // In a small window the newer of the two panels at the left replaces the older.
    const bool both = panels_.view && panels_.timings;
    if (both && static_cast<float>(window_.size().x) < 4.5f * ui::panelReach(interface_.context()))
        (timingsAreNewer_ ? panels_.view : panels_.timings) = false;
    timingsAreNewer_ = panels_.view;
}

void DesktopApp::watchShaders() {
    if ((!gl::debugBuild() && !options_.watchShaders) || now() < nextShaderLook_) return;
    nextShaderLook_ = now() + kShaderLookEvery;
    shaders_.reloadChanged();
    std::string faults;
    for (const std::string& fault : shaders_.standingFaults())
        faults += "\n" + fault;
    if (faults.empty())
        messages_.clear("shader");
    else
        messages_.hold("The old shader runs on; the changed one was refused:" + faults, "shader");
}

void DesktopApp::countFrame(double seconds) {
    ++frames_;
    // Averaged over about half a second, so that the figure can be read.
    const double share = std::clamp(seconds * 2, 0.02, 1.0);
    frameSeconds_ += (seconds - frameSeconds_) * share;
    figures_.framesPerSecond = frameSeconds_ > 0 ? 1 / frameSeconds_ : 0;
}

void DesktopApp::pace(Clock::time_point begin) const {
    const auto shortest = std::chrono::duration<double>(kShortestFrame);
    const auto rest = shortest - (Clock::now() - begin);
    if (rest <= rest.zero()) return;
    const InWork waiting(WorkPlace::waiting);
    std::this_thread::sleep_for(rest);
}

void DesktopApp::takePicture() {
    pictureAsked_ = false;
    try {
        screenshot_ = saveScreenshot(window_.pixels()).string();
        messages_.note("Picture saved as " + screenshot_, now(), "picture");
    } catch (const std::exception& fault) {
        messages_.warn(fault.what(), now(), "picture");
    }
}

void DesktopApp::tellTelemetry() {
    if (!telemetry_.due(now())) return;
    meter_.pause();
    const LessonSections& lesson = session_.sections();
    const std::vector<const ParameterSection*> sections{&lesson.start,      &lesson.view,    &lesson.surface,
                                                        &lesson.simulation, &windowSection_, &controlSection_,
                                                        &panelSection_};
    std::vector<std::string> passes;
    for (const gl::PassTime& pass : profiler_.passes())
        passes.push_back(pass.name);
    telemetry_.write({session_.running() ? "running" : "start", now(), frames_, session_.steps(),
                      session_.running() ? session_.torch() : TorchSample{}, controls_, panels_, figures_, sections,
                      passes, messages_, interface_.context(), window_.size(), window_.pixels(), screenshot_,
                      headset_ ? headset_->status() : HeadsetStatus{}, meter_, callsCounted_});
    meter_.resume();
}

} // namespace meltpool
