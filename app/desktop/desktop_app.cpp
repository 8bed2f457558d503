#include "app/desktop/desktop_app.hpp"

#include "app/library/best_kept.hpp"
#include "app/library/kept_attempts.hpp"
#include "app/platform/program_info.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

namespace meltpool {

namespace {

/// Sleep between two looks at the input if nothing moves, s: window minimised, a page before the lesson, or a lesson
/// with a still picture.
constexpr double kRest = 0.1;
std::string driverText(const gl::ContextInfo& info) {
    return info.software ? phrase("desk.on_processor", {{"driver", info.renderer}}) : info.renderer;
}

} // namespace

DesktopApp::DesktopApp(const DesktopOptions& options)
    : options_(options),
      telemetry_(options.telemetry),
      window_(Window::Options{}),
      interface_(window_),
      menus_(window_, interface_),
      shaders_(resourceFolder() / "shaders"),
      steps_(shaders_.root()),
      home_(LessonFolders::ofUser(), settingsFolder() / "best-scores.toml", personsFolder()),
      session_(shaders_, loadLesson(options.lesson.empty() ? std::string(kDefaultLesson) : options.lesson),
               machineSeconds, steps_.thread()),
      sound_(session_),
      sections_(controls_, menus_.panels, session_),
      settings_(options.settings),
      lessons_(home_, session_, settings_, controls_, messages_),
      welders_(home_, session_, messages_),
      picture_(shaders_),
      detail_(window_.driver().software),
      driver_(driverText(window_.driver())) {
    headset_.open(options_, settingsFolder());
    session_.log().records().use(options_.record, programBuild(), window_.driver().renderer);
    if (options_.recordings)
        session_.log().recordings().use(recordingsFolder(), programBuild(), window_.driver().renderer);
    telemetry_.countCalls();
    for (std::string& fault : settings_.load(sections_.forFile(headsetSection())))
        messages_.warn(std::move(fault), clock_.now());
    takeLanguage();
    takeUnits();
    if (chosenUnits() != UnitSystem::metric && !options.lesson.empty())
        session_.open(loadLesson(options.lesson)); // its text was read before the settings
    takeWelder();
    takeGhost();
    settings_.giveTo(session_.lesson(), session_.sections());
    for (const std::string& fault : home_.scores.faults())
        messages_.warn(fault, clock_.now());
    for (const std::string& fault : home_.faults())
        messages_.warn(fault, clock_.now());
    home_.open = options.lesson.empty();
    if (!home_.open) home_.choose(session_.lesson().key);
    if (!options.replay.empty())
        lessons_.openAttempt(options.replay, clock_.now(), options.lesson);
    else if (!options.lesson.empty())
        lessons_.tellPath(clock_.now());
    window_.resize({sections_.window.width, sections_.window.height}, sections_.window.maximised);
    window_.show();
    clock_.restart();
}

/// Abandons steps of the ending session, which a fault in a picture may have left running.
DesktopApp::~DesktopApp() {
    steps_.abandon();
}

/// Takes the person named on the command line; without one the home page asks if there are names to choose from.
void DesktopApp::takeWelder() {
    welders_.use(sections_.ofPerson(headsetSection()));
    for (const std::string& fault : home_.who.persons().faults())
        messages_.warn(fault, clock_.now());
    if (options_.person) {
        if (!home_.who.take(*options_.person)) throw InputError("--person: " + home_.who.refusal());
        welders_.enter(clock_.now());
    } else if (options_.lesson.empty() && options_.replay.empty() && !home_.who.persons().all().empty()) {
        home_.who.ask();
    }
}

/// Reads the ghost's file early: a wrong file ends the program before the window shows anything, as far as the lesson
/// is known by then.
void DesktopApp::takeGhost() {
    session_.attempt().ghost().findBestBy([this](const std::string& lesson) {
        const AttemptOwner& welder = home_.who.welder();
        if (welder.kind == AttemptOwner::Kind::guest) return std::filesystem::path();
        return bestKept(recordingsFolder(), lesson, welder.person.id);
    });
    if (options_.ghost.empty()) return;
    std::error_code missing;
    if (!std::filesystem::is_regular_file(options_.ghost, missing))
        throw InputError(options_.ghost, 0, "is not a file; expected an attempt or a torch path for --ghost");
    const Lesson& lesson = session_.lesson();
    if (!options_.lesson.empty() && lesson.model == LessonModel::Weld) ghostTorch(lesson, options_.ghost);
    session_.attempt().ghost().choose(std::filesystem::absolute(options_.ghost));
}

/// Returns null without a headset.
ParameterSection* DesktopApp::headsetSection() {
    return headset_.device() ? &headset_.device()->section() : nullptr;
}

/// Speaks the language that the person chose, or the former one if the words file has a fault.
void DesktopApp::takeLanguage() {
    try {
        if (speakChosenLanguage(sections_.window.language)) home_.refresh();
    } catch (const InputError& fault) {
        messages_.warn(fault.what(), clock_.now());
        sections_.window.language = spokenLanguageChoice();
    }
}

/// Shows lengths as the person chose; the lessons' texts are read again.
void DesktopApp::takeUnits() {
    const auto wanted = static_cast<UnitSystem>(sections_.window.units);
    if (wanted == chosenUnits()) return;
    chooseUnits(wanted);
    home_.refresh();
}

bool DesktopApp::finish() {
    finishJudging();
    session_.end("the program ended");
    session_.log().recordings().finish();
    const glm::ivec2 size = window_.normalSize();
    sections_.window.width = std::clamp(size.x, 640, 16384);
    sections_.window.height = std::clamp(size.y, 480, 16384);
    sections_.window.maximised = window_.maximised();
    bool kept = true;
    for (const std::string& fault : welders_.leave())
        std::fprintf(stderr, "meltpool: %s\n", printable(fault, 3000).c_str());
    try {
        settings_.takeFrom(session_.lesson(), session_.sections());
        for (const std::string& fault : settings_.save(sections_.forFile(headsetSection())))
            std::fprintf(stderr, "meltpool: %s\n", printable(fault, 3000).c_str());
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "meltpool: the settings were not saved: %s\n", fault.what());
        kept = false;
    }
    if (session_.log().records().lost())
        std::fprintf(stderr, "meltpool: an attempt was not recorded to its end; expected %s\n",
                     "a place for --record that stays writable");
    const std::string& unrecorded = session_.log().recordings().lost();
    if (!unrecorded.empty()) std::fprintf(stderr, "meltpool: %s\n", printable(unrecorded, 3000).c_str());
    if (!screenshots_.lost().empty())
        std::fprintf(stderr, "meltpool: a picture was not saved: %s\n", printable(screenshots_.lost(), 3000).c_str());
    return kept && unrecorded.empty() && screenshots_.lost().empty() && !session_.log().records().lost() &&
           telemetry_.fault().empty();
}

void DesktopApp::frame() {
    if (!telemetry_.enabled()) return runFrame();
    const bool headset = headset_.inFrame() != nullptr;
    telemetry_.beginFrame();
    runFrame();
    StepThread* const thread = steps_.thread();
    telemetry_.endFrame(thread ? thread->takeCosts() : WorkCosts{}, headset != (headset_.inFrame() != nullptr));
}

bool DesktopApp::rests() const {
    if (headset_.inFrame()) return false;
    // A headset that is about to open with its lesson must not wait.
    const bool before =
        !session_.running() && (home_.open || !headset_.device()) && !session_.activities().current().hurries();
    const bool still = before || picture_.stands();
    return window_.minimised() || (still && !window_.stirred());
}

void DesktopApp::runFrame() {
    const auto begin = std::chrono::steady_clock::now();
    InputFrame input = window_.poll(rests() ? kRest : 0);
    const double seconds = clock_.next();
    const double time = clock_.frame();
    beginHeadset(seconds);
    if (window_.minimised() && !headset_.inFrame()) return;

    messages_.expire(time);
    if (gl::debugBuild() || options_.watchShaders) shaderWatch_.update(shaders_, steps_.thread(), messages_, time);
    const bool captured = session_.running() && controls_.captured();
    takeLanguage();
    takeUnits();
    interface_.takeGamepad(input, gamepadUse(), seconds);
    interface_.begin(sections_.window.interfaceSize, captured, keysChoose(), input);
    interface_.takeInput(input, captured);
    keepFromTorch(input);
    handleKeys(input);
    tellRecordings(session_.log().recordings(), time, messages_);
    detail_.update(sections_.window.detail, session_.running(), headset_.inFrame() != nullptr);
    session_.picture().setDetail(detail_.level());
    figures_.detail = detailSentence(detail_.level());
    const bool timed = menus_.panels.timings && !menus_.panels.hidden;
    if (timed) profiler_.beginFrame();
    picture_.count(session_, seconds, steps_.ofLastFrame());
    simulate(input, seconds);
    drawHeadset(seconds);
    preparePicture(seconds);
    const MenuRequest request = drawMenus();
    tellMissingLetters();
    sound_.update(session_, controls_, headset_.inFrame());
    pacer_.count(seconds);
    figures_.framesPerSecond = pacer_.framesPerSecond();
    writeTelemetry();
    show();
    if (timed) profiler_.endFrame();
    if (screenshots_.asked()) screenshots_.take(picture_, session_, window_.pixels(), messages_, clock_.now());
    window_.swap();
    finishSteps(seconds);
    if (request != MenuRequest::none) menus_.unfocus();
    act(request);
    settleQuestions();
    window_.captureMouse(session_.running() && controls_.captured());
    if (!headset_.inFrame()) pacer_.pace(begin);
}

/// Draws surface, picture and menus. If the processor draws, the metal's steps run in parallel. The picture shows the
/// metal before these steps.
void DesktopApp::show() {
    steps_.begin([this] { session_.run().makeSteps(nullptr); });
    drawPicture();
    const gl::Scope scope(&profiler_, "interface");
    interface_.end();
}

void DesktopApp::beginHeadset(double seconds) {
    const bool putOn = headset_.begin(session_, home_, messages_, seconds, clock_.now());
    if (headset_.device()) window_.waitForDisplay(!headset_.inFrame());
    seats_.update(headset_.inFrame() != nullptr, controls_.captured(), clock_.frame());
    if (headset_.device()) headset_.device()->ask(&seats_.question(Seat::headset));
    // The lesson starts when a person first puts the headset on.
    if (putOn && !session_.running()) start(&LessonSession::begin);
}

void DesktopApp::drawHeadset(double seconds) {
    WindowHeadset* const headset = headset_.inFrame();
    if (!headset) return;
    const gl::Scope scope(&profiler_, "headset");
    MenuRequest request = MenuRequest::none;
    detail_.draw([&] { request = headset->draw(session_, home_, figures_, messages_, seconds, &profiler_); });
    headset->end();
    act(request, Seat::headset);
}

/// Carries out the answers to questions at both places.
void DesktopApp::settleQuestions() {
    for (const Seat seat : {Seat::desk, Seat::headset})
        if (const MenuRequest confirmed = seats_.takeConfirmed(seat); confirmed != MenuRequest::none)
            for (const DesktopAction& action : desktopActions())
                if (action.request == confirmed) perform(action, seat);
    session_.settle(controls_);
}

void DesktopApp::simulate(const InputFrame& input, double seconds) {
    if (!session_.running()) { // messages of the lesson have ended
        figures_.caption = {};
        notices_.update(session_, figures_, controls_.triggerLock(), seconds, messages_);
        session_.advance(controls_, seconds, nullptr); // step of a comparison
        return;
    }
    controls_.update(input, seconds);
    // A captured mouse leads the torch, even with a headset in use.
    const TorchSource held = headset_.inFrame() && !controls_.captured() ? headset_.inFrame()->torch() : TorchSource{};
    if (held) controls_.putOut(ArcOut::takenOver);
    const bool beside = stepsBesidePicture();
    session_.run().stepBeside(beside ? steps_.timeBeside(seconds) : 0);
    const bool due = session_.beginSteps(controls_, seconds, &profiler_, held);
    if (due && beside) return steps_.postpone();
    if (due) {
        session_.run().makeSteps(&profiler_);
        session_.run().finishSteps();
    }
    tellLesson(seconds);
}

/// Returns true if the steps run while the picture is drawn. The timings panel shows each pass alone. The headset's
/// runtime decides when the headset's frame ends.
bool DesktopApp::stepsBesidePicture() const {
    const bool timed = menus_.panels.timings && !menus_.panels.hidden;
    return steps_.possible() && !headset_.inFrame() && !timed;
}

void DesktopApp::finishSteps(double seconds) {
    if (!steps_.finish()) return;
    session_.run().finishSteps();
    tellLesson(seconds);
}

/// Passes the changes of the newest steps to menus, messages and headset.
void DesktopApp::tellLesson(double seconds) {
    fillFigures(figures_, session_);
    takeJudgement();
    if (session_.run().recordFault().empty())
        messages_.clear("record");
    else
        messages_.hold(phrase("desk.message.record_stopped", {{"reason", session_.run().recordFault()}}), "record");
    const WindowHeadset* const hand = controls_.captured() ? nullptr : headset_.inFrame();
    notices_.update(session_, figures_, hand ? hand->triggerLock() : controls_.triggerLock(), seconds, messages_);
    const bool pause = headset_.inFrame() && controls_.mode() == Mode::view;
    if (pause && session_.activities().allowed().ownTorch)
        messages_.hold(phrase("notice.pause.told"), "pause");
    else
        messages_.clear("pause");
    if (!session_.run().fault().empty())
        messages_.hold(phrase("desk.message.simulation_stopped", {{"reason", session_.run().fault()}}), "metal");
    else if (figures_.refused > 0)
        messages_.hold(phrase("desk.message.unstable"), "metal");
    else
        messages_.clear("metal");
}

/// Shows a new judgement and saves its score if it is the best.
void DesktopApp::takeJudgement() {
    if (session_.attempt().judgements() == judgements_) return;
    judgements_ = session_.attempt().judgements();
    menus_.showResult(session_);
    controls_.lendMouse(); // to read and press
    sound_.judged(session_);
    lessons_.keepScore(session_.leader() == TorchLeader::hand && headset_.device()
                           ? static_cast<double>(headset_.device()->zoom())
                           : 1,
                       clock_.now());
}

/// Judges a weld that still waits for its judgement, and shows the result; false if none waits.
bool DesktopApp::finishJudging() {
    if (!session_.judges() || !session_.run().fault().empty()) return false;
    bool judged = false;
    session_.run().guarded([&] { judged = session_.attempt().finishWeld(*session_.run().trainer()); });
    if (!judged) return false;
    session_.run().metalChanged();
    session_.run().clock().restart();
    controls_.putOut(ArcOut::lessonBegan);
    takeJudgement();
    return true;
}

void DesktopApp::preparePicture(double seconds) {
    if (!session_.running()) return;
    const glm::ivec2 pixels = window_.pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (headset_.inFrame() && headset_.inFrame()->mirror(pixels, shaders_)) return;
    const CoveredEdges covered = menus_.covered();
    session_.picture().frameCamera(controls_, covered,
                                   static_cast<float>(pixels.x) / static_cast<float>(std::max(pixels.y, 1)));
    picture_.prepare(session_, controls_,
                     {pixels,
                      {covered.shift(), covered.lift()},
                      seconds,
                      sections_.window.picture,
                      screenshots_.windowAsked(),
                      steps_.due()},
                     &profiler_);
    figures_.picture = picture_.sentence();
}

void DesktopApp::drawPicture() {
    if (picture_.prepared()) return detail_.draw([this] { picture_.draw(session_, &profiler_); });
    if (session_.running()) return; // the headset's mirror fills the window
    const glm::ivec2 pixels = window_.pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, pixels.x, pixels.y);
    glClearColor(0.07f, 0.08f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

MenuRequest DesktopApp::drawMenus() {
    return menus_.draw({session_, home_, controls_, messages_, figures_, profiler_, pacer_.frameSeconds() * 1000,
                        driver_, sections_.forViewMenu(headsetSection()), seats_.question(Seat::desk),
                        headset_.inFrame() != nullptr, clock_.now()});
}

/// Reports letters that no font here has. They come in names of lessons and files that people bring.
void DesktopApp::tellMissingLetters() {
    ImFont& font = *interface_.context().fonts.body;
    const auto look = [&](std::string_view text) { missingLetters_.look(font, text); };
    for (const Message& message : messages_.shown())
        look(message.text);
    if (home_.open) {
        for (const CataloguedLesson& lesson : home_.lessons()) {
            look(lesson.title);
            look(lesson.text);
        }
        if (home_.who.asked())
            for (const KnownPerson& person : home_.who.persons().all())
                look(person.name);
        if (home_.attempts.shown())
            for (const ReplayEntry& entry : home_.attempts.entries())
                look(entry.detail);
    } else if (!session_.running()) {
        look(session_.lesson().title);
        look(session_.lesson().text);
    }
    const auto told = missingLetters_.take();
    if (!told) return;
    std::fprintf(stderr, "meltpool: %s\n", printable(told->terminal, 3000).c_str());
    messages_.warn(told->window, clock_.now());
}

void DesktopApp::writeTelemetry() {
    if (!telemetry_.due(clock_.now())) return;
    const std::vector<const ParameterSection*> sections = sections_.forTelemetry();
    std::vector<std::string> passes;
    for (const gl::PassTime& pass : profiler_.passes())
        passes.push_back(pass.name);
    const char* page = home_.open ? "home" : session_.running() ? "running" : "start";
    telemetry_.write({page,
                      clock_.frame(), // time that the metal's time belongs to, however long the frame takes
                      pacer_.frames(),
                      session_.run().steps(),
                      session_.running() ? session_.run().torch() : TorchSample{},
                      controls_,
                      menus_.panels,
                      figures_,
                      sections,
                      passes,
                      messages_,
                      interface_.context(),
                      window_.size(),
                      window_.pixels(),
                      screenshots_.saved(),
                      steps_.ofLastFrame().has_value(),
                      session_.attempt().judged(),
                      session_.activities(),
                      session_.picture().cut(),
                      headset_.device() ? headset_.device()->status() : HeadsetStatus{}});
    if (telemetry_.fault().empty()) return;
    messages_.hold(phrase("desk.message.telemetry_stopped", {{"reason", telemetry_.fault()}}), "telemetry");
    std::fprintf(stderr, "meltpool: %s\n", telemetry_.fault().c_str());
}

} // namespace meltpool
