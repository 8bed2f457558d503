#include "app/desktop/desktop_app.hpp"

#include "app/desktop/screenshot.hpp"
#include "app/program/call_counters.hpp"
#include "app/program/program_info.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <utility>

namespace meltpool {

namespace {

/// s that a window sleeps between looks at its input where nothing moves: minimised, or on a page before the lesson.
constexpr double kRest = 0.1;
/// How long a headset that was asked for may take to open, s: far beyond what it takes on a busy machine.
constexpr double kHeadsetPatience = 120;

std::string driverText(const gl::ContextInfo& info) {
    return info.renderer + (info.software ? " \xE2\x80\x93 drawn on the processor, without a graphics card" : "");
}

} // namespace

DesktopApp::DesktopApp(const DesktopOptions& options)
    : options_(options),
      telemetry_(options.telemetry),
      window_(Window::Options{}),
      interface_(window_),
      menus_(window_, interface_),
      shaders_(resourceFolder() / "shaders"),
      home_(resourceFolder() / "data" / "lessons", settingsFolder() / "best-scores.toml"),
      session_(shaders_, loadLesson(options.lesson.empty() ? std::string(kDefaultLesson) : options.lesson)),
      windowSection_("window", describe(windowParameters_)),
      controlSection_("controls", describe(controls_.parameters)),
      panelSection_("panels", describe(menus_.panels)),
      settings_(options.settings),
      lessons_(home_, session_, settings_, controls_, messages_),
      driver_(driverText(window_.driver())) {
    if (options_.headset != HeadsetUse::off && options_.makeHeadset) headset_ = options_.makeHeadset(settingsFolder());
    session_.records().use(options_.record, programBuild(), window_.driver().renderer);
    if (telemetry_.enabled()) callsCounted_ = joinCallCounters();
    for (std::string& fault : settings_.load(ownSections()))
        messages_.warn(std::move(fault), now());
    settings_.giveTo(session_.lesson(), session_.sections());
    for (const std::string& fault : home_.scores.faults())
        messages_.warn(fault, now());
    home_.open = options.lesson.empty();
    home_.choose(session_.lesson().key);
    window_.resize({windowParameters_.width, windowParameters_.height}, windowParameters_.maximised);
    window_.show();
    lastFrame_ = now();
}

std::vector<ParameterSection*> DesktopApp::ownSections() {
    std::vector<ParameterSection*> sections{&windowSection_, &controlSection_, &panelSection_, &session_.cueSection()};
    if (headset_) sections.push_back(&headset_->section());
    return sections;
}

bool DesktopApp::finish() {
    session_.end("the program ended");
    const glm::ivec2 size = window_.normalSize();
    windowParameters_.width = std::clamp(size.x, 640, 16384);
    windowParameters_.height = std::clamp(size.y, 480, 16384);
    windowParameters_.maximised = window_.maximised();
    bool kept = true;
    try {
        settings_.takeFrom(session_.lesson(), session_.sections());
        settings_.save(ownSections());
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "meltpool: the settings were not saved: %s\n", fault.what());
        kept = false;
    }
    if (session_.records().lost())
        std::fprintf(stderr, "meltpool: an attempt was not recorded to its end, as the window told; expected %s\n",
                     "a place for --record that can be written, with free space");
    return kept && !session_.records().lost() && telemetry_.fault().empty();
}

void DesktopApp::frame() {
    if (!telemetry_.enabled()) return runFrame();
    const bool headset = headsetFrame_;
    meter_.begin();
    runFrame();
    meter_.end();
    if (headset != headsetFrame_) meter_.restart(); // frames with and without headset are not comparable
}

bool DesktopApp::rests() const {
    if (headsetFrame_) return false;
    // A headset that is about to open with its lesson is not kept waiting.
    const bool still = !session_.running() && (home_.open || !headset_);
    return window_.minimised() || (still && !window_.stirred());
}

void DesktopApp::runFrame() {
    const Clock::time_point begin = Clock::now();
    InputFrame input = window_.poll(rests() ? kRest : 0);
    const double time = now();
    const double seconds = time - lastFrame_;
    lastFrame_ = time;
    beginHeadset(seconds);
    if (window_.minimised() && !headsetFrame_) return;

    messages_.expire(time);
    if (gl::debugBuild() || options_.watchShaders) shaderWatch_.update(shaders_, messages_, time);
    const bool captured = session_.running() && controls_.captured();
    interface_.begin(windowParameters_.interfaceSize, captured, !session_.running() && !home_.open);
    interface_.takeInput(input, captured);
    handleKeys(input);
    const bool timed = menus_.panels.timings && !menus_.panels.hidden;
    if (timed) profiler_.beginFrame();
    simulate(input, seconds);
    drawHeadset(seconds);
    drawPicture(seconds);
    MenuRequest request = MenuRequest::none;
    {
        const gl::Scope scope(&profiler_, "interface");
        request = drawMenus();
        interface_.end();
    }
    if (timed) profiler_.endFrame();
    if (pictureAsked_) takePicture();
    pacer_.count(seconds);
    figures_.framesPerSecond = pacer_.framesPerSecond();
    writeTelemetry();
    window_.swap();
    act(request);
    session_.settle(controls_);
    window_.captureMouse(session_.running() && controls_.captured());
    if (!headsetFrame_) pacer_.pace(begin);
}

void DesktopApp::beginHeadset(double seconds) {
    headsetFrame_ = headset_ && headset_->begin(session_, home_, seconds);
    if (!headset_) return;
    if (options_.headset == HeadsetUse::wanted && headset_->openings() == 0 &&
        (headset_->hopeless() || now() > kHeadsetPatience))
        throw InputError("there is no headset to use: " + headset_->sentence());
    window_.waitForDisplay(!headsetFrame_);
    if (headset_->warning().empty())
        messages_.clear("headset");
    else
        messages_.hold(headset_->warning(), "headset");
    // The lesson starts when somebody first puts the headset on.
    if (headsetFrame_ && !headsetStarted_ && !session_.running()) start(&LessonSession::begin);
    headsetStarted_ = headsetStarted_ || headsetFrame_;
}

void DesktopApp::drawHeadset(double seconds) {
    if (!headsetFrame_) return;
    const gl::Scope scope(&profiler_, "headset");
    const MenuRequest request = headset_->draw(session_, home_, figures_, messages_, seconds, &profiler_);
    headset_->end();
    act(request);
}

/// Keys of the pages before a lesson runs.
void DesktopApp::moveByKeys(const InputFrame& input) {
    if (menus_.panels.help) return;
    for (const Key key : input.pressed) {
        if (!home_.open) break;
        home_.move((key == Key::right) - (key == Key::left), (key == Key::down) - (key == Key::up));
    }
    // Dear ImGui itself takes the key for the control that was chosen by keys.
    if (std::find(input.struck.begin(), input.struck.end(), Key::enter) == input.struck.end()) return;
    if (home_.open)
        act(MenuRequest::openLesson);
    else if (!ImGui::GetIO().NavVisible)
        act(MenuRequest::start);
}

/// Keys of the demonstration: pause, its time, and Enter for one's own attempt.
void DesktopApp::demonstrateByKeys(const InputFrame& input) {
    Demonstration& demonstration = session_.demonstration();
    if (!demonstration.shown() || menus_.panels.help) return;
    for (const Key key : input.pressed) {
        if (key == Key::left) demonstration.moveTo(demonstration.time() - Demonstration::kKeyStep);
        if (key == Key::right) demonstration.moveTo(demonstration.time() + Demonstration::kKeyStep);
    }
    for (const Key key : input.struck) {
        if (key == Key::space) demonstration.toggle();
        if (key == Key::enter) act(MenuRequest::reset);
    }
}

void DesktopApp::handleKeys(const InputFrame& input) {
    if (session_.running())
        demonstrateByKeys(input);
    else
        moveByKeys(input);
    for (const Key key : input.struck) {
        switch (key) {
        case Key::escape:
            if (!session_.running() && !menus_.panels.help) act(MenuRequest::home);
            menus_.panels.help = false;
            break;
        case Key::tab:
            menus_.panels.hidden = session_.running() && !menus_.panels.hidden;
            break;
        case Key::f1:
            menus_.panels.help = !menus_.panels.help;
            break;
        case Key::f2:
            menus_.panels.view = !menus_.panels.view;
            break;
        case Key::f3:
            menus_.panels.simulation = !menus_.panels.simulation;
            break;
        case Key::f4:
            menus_.panels.timings = !menus_.panels.timings;
            break;
        case Key::h:
            if (session_.demonstration().shown() || !session_.arc().burns()) act(MenuRequest::home);
            break;
        case Key::j:
            act(MenuRequest::judge);
            break;
        case Key::x:
            act(MenuRequest::cut);
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
    case MenuRequest::home:
        lessons_.goHome();
        menus_.panels.help = menus_.panels.result = false;
        break;
    case MenuRequest::openLesson:
        lessons_.open(home_.chosen(), now());
        break;
    case MenuRequest::next:
        if (const CataloguedLesson* next = home_.find(session_.lesson().next)) lessons_.open(*next, now());
        menus_.panels.result = false;
        break;
    case MenuRequest::startWithDefaults:
        session_.sections().restoreDefaults();
        start(&LessonSession::begin);
        break;
    case MenuRequest::start:
        start(&LessonSession::begin);
        break;
    case MenuRequest::demonstrate:
        start(&LessonSession::demonstrate);
        break;
    case MenuRequest::reset:
        session_.reset(controls_);
        break;
    case MenuRequest::judge:
        session_.judge();
        menus_.showResult(session_);
        break;
    case MenuRequest::cut:
        session_.toggleCut(controls_);
        if (session_.cut().shown()) menus_.showResult(session_);
        break;
    case MenuRequest::restart:
        lessons_.leave();
        menus_.panels.help = menus_.panels.result = false;
        profiler_.reset();
        break;
    case MenuRequest::none:
        break;
    }
}

void DesktopApp::start(void (LessonSession::*begin)(Controls&)) {
    if (!lessons_.start(begin, now())) return;
    menus_.panels.hidden = false;
    profiler_.reset();
}

void DesktopApp::simulate(const InputFrame& input, double seconds) {
    if (!session_.running()) return;
    controls_.update(input, seconds);
    // While the mouse is captured it leads the torch, even with a headset in use.
    const TorchSource held = headsetFrame_ && !controls_.captured() ? headset_->torch() : TorchSource{};
    if (held) controls_.putOut(ArcOut::takenOver);
    session_.advance(controls_, seconds, &profiler_, held);
    session_.fillFigures(figures_);
    takeJudgement();
    if (session_.recordFault().empty())
        messages_.clear("record");
    else
        messages_.hold("The record of this attempt has stopped: " + session_.recordFault(), "record");
    notices_.update(session_, figures_, held ? headset_->triggerLock() : controls_.triggerLock(), seconds, messages_);
    if (!session_.fault().empty())
        messages_.hold("The simulation has stopped: " + session_.fault() + ". Reset starts it again.", "metal");
    else if (figures_.refused > 0)
        messages_.hold(
            "The metal became unstable: the new state of some particles was not finite, and they kept their old one. "
            "Reduce the time step, the heat or the stiffness; Reset starts again.",
            "metal");
    else
        messages_.clear("metal");
}

/// A new judgement is shown, and its score kept where it is the best.
void DesktopApp::takeJudgement() {
    if (session_.judgements() == judgements_) return;
    judgements_ = session_.judgements();
    menus_.showResult(session_);
    lessons_.keepScore(session_.held() && headset_ ? static_cast<double>(headset_->zoom()) : 1, now());
}

void DesktopApp::drawPicture(double seconds) {
    const glm::ivec2 pixels = window_.pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (session_.running()) {
        if (headsetFrame_ && headset_->mirror(pixels)) return;
        // The metal moves smoothly to the middle of what the panels leave free.
        shift_ += (menus_.middleOfPicture() - shift_) * std::min(1.0f, static_cast<float>(seconds) * 10);
        session_.draw(controls_, pixels, shift_, &profiler_);
        return;
    }
    glViewport(0, 0, pixels.x, pixels.y);
    glClearColor(0.07f, 0.08f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

MenuRequest DesktopApp::drawMenus() {
    LessonSections& lesson = session_.sections();
    const std::array<const ParameterSection*, 6> view{
        &session_.cueSection(), &lesson.view,    &lesson.surface,
        &controlSection_,       &windowSection_, headset_ ? &headset_->section() : nullptr};
    return menus_.draw({session_, home_, controls_, messages_, figures_, profiler_, pacer_.frameSeconds() * 1000,
                        driver_, std::span(view).first(headset_ ? 6 : 5)});
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

void DesktopApp::writeTelemetry() {
    if (!telemetry_.due(now())) return;
    meter_.pause();
    const LessonSections& lesson = session_.sections();
    const std::vector<const ParameterSection*> sections{&lesson.start,      &lesson.view,          &lesson.surface,
                                                        &lesson.simulation, &windowSection_,       &controlSection_,
                                                        &panelSection_,     &session_.cueSection()};
    std::vector<std::string> passes;
    for (const gl::PassTime& pass : profiler_.passes())
        passes.push_back(pass.name);
    const char* page = home_.open ? "home" : session_.running() ? "running" : "start";
    telemetry_.write({page,
                      lastFrame_, // which the metal's time belongs to, however long the frame takes
                      pacer_.frames(),
                      session_.steps(),
                      session_.running() ? session_.torch() : TorchSample{},
                      controls_,
                      menus_.panels,
                      figures_,
                      sections,
                      passes,
                      messages_,
                      interface_.context(),
                      window_.size(),
                      window_.pixels(),
                      screenshot_,
                      session_.judged(),
                      session_.demonstration(),
                      session_.cut(),
                      headset_ ? headset_->status() : HeadsetStatus{},
                      meter_,
                      callsCounted_});
    meter_.resume();
    if (telemetry_.fault().empty()) return;
    messages_.hold("The telemetry has stopped: " + telemetry_.fault(), "telemetry");
    std::fprintf(stderr, "meltpool: %s\n", telemetry_.fault().c_str());
}

} // namespace meltpool
