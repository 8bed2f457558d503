#include "app/headset/headset_front_end.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace meltpool {

namespace {

xr::HeadsetSettings settingsOf(const HeadsetParameters& parameters) {
    xr::HeadsetSettings settings;
    settings.resolutionScale = parameters.resolutionScale;
    settings.samples = parameters.samples;
    settings.notice = HeadsetNotice::kShape;
    return settings;
}

xr::Pose middleOf(const std::array<xr::EyeView, 2>& eyes) {
    return xr::interpolate(eyes[0].pose, eyes[1].pose, 0.5f);
}

Stance stanceOf(LessonSession& session) {
    const Lesson& lesson = session.lesson();
    if (lesson.model != LessonModel::Weld) return {};
    return stanceFor(beforeFace(session.picture().fixture()), lesson.torch);
}

} // namespace

HeadsetFrontEnd::HeadsetFrontEnd(const std::filesystem::path& folder)
    : section_("headset", describe(parameters_)),
      connection_(settingsOf(parameters_)),
      place_(parameters_.tableHeight, 1.0f, 0.0f),
      hands_(parameters_, folder),
      panel_(parameters_),
      view_(parameters_) {}

/// Ends the headset's frame if a call on it fails or is abandoned; the window continues without it.
void HeadsetFrontEnd::guarded(FunctionRef<void()> work) {
    try {
        work();
    } catch (const xr::XrFault& fault) {
        inFrame_ = false;
        hands_.lose(ArcOut::runtimeLost);
        connection_.onFault(fault);
    } catch (const xr::Stalled&) {
        inFrame_ = false;
        hands_.lose(ArcOut::runtimeLost);
        connection_.onStall();
    }
}

bool HeadsetFrontEnd::begin(LessonSession& session, const Home& home, double elapsed) {
    inFrame_ = false;
    mirrored_ = false;
    if (changes_.lessonBegan(session)) {
        arcBurned_ = false;
        hands_.forgetSteps();
        hands_.putOut(session.log().redo().redone() > 0 ? ArcOut::redone : ArcOut::lessonBegan);
    }
    const bool weld = session.lesson().model == LessonModel::Weld;
    if (weld && changes_.lessonStarted()) parameters_.weldZoom = 1;
    section_.idle = idleParameters(weld);
    if (parameters_.table == HeadsetParameters::kSetHeight) parameters_.tableHeight = parameters_.setHeight;
    place_ = WorkpiecePlace(parameters_.tableHeight, shownZoom(parameters_, weld), session.picture().bottom(),
                            beforeFace(session.picture().fixture()), stanceOf(session));
    connection_.use(settingsOf(parameters_)); // the settings file may have been read since the start
    const bool runs = connection_.update() == xr::ConnectionState::running;
    drawn_ = drawn_ && connection_.headset() != nullptr;
    changes_.takeConnection(
        runs, hands_, connection_.state() == xr::ConnectionState::asleep ? ArcOut::notFocused : ArcOut::runtimeLost,
        session);
    session.values().takeHand(weldingHand(runs));
    if (!runs) return false;
    guarded([&] {
        timing_ = connection_.headset()->waitFrame();
        const Clock::time_point start = Clock::now();
        inFrame_ = true;
        readHands(session, home, elapsed);
        busy_ = std::chrono::duration<double>(Clock::now() - start).count();
    });
    return inFrame_;
}

std::optional<WeldingHand> HeadsetFrontEnd::weldingHand(bool runs) const {
    if (!runs) return std::nullopt;
    return hands_.torchHand() == xr::Hand::right ? WeldingHand::right : WeldingHand::left;
}

void HeadsetFrontEnd::readHands(LessonSession& session, const Home& home, double elapsed) {
    xr::Headset& headset = *connection_.headset();
    const xr::Input& input = headset.input();
    placeWorkshop(session, elapsed);
    panel_.update(input.hands(), workshop_, headset.panel().shape(), hands_.torchHand(), torchWorks(session));
    followPage(session, home);
    movePanel(session, elapsed);
    holdAgain(session, input, elapsed);
    if (headset.mode() == xr::SessionMode::focused)
        focusedOpening_ = connection_.openings();
    else
        hands_.lose(ArcOut::notFocused);
    if (session.run().steps() > 0 && session.leader() != TorchLeader::hand) {
        hands_.putOut(ArcOut::takenOver);
        hands_.forgetSteps();
    }
    changes_.takeParameters(parameters_, place_.zoom, hands_, session);
    const bool weld = session.lesson().model == LessonModel::Weld;
    hands_.update(input, workshop_, weld ? torchGeometry(session.lesson().process) : kPlainTorch, elapsed);
    if (panel_.pointingHand() == hands_.torchHand()) hands_.putOut(ArcOut::panel);
    if (session.paused()) hands_.putOut(ArcOut::paused);
    changes_.takeTorch(hands_, session);
    view_.update(session, hands_.torch(), page_ != Page::work, elapsed);
}

HeadsetFrontEnd::Page HeadsetFrontEnd::pageOf(const LessonSession& session, const Home& home) {
    if (home.open) return Page::home;
    if (!session.running()) return Page::lesson;
    return session.attempt().judged() ? Page::result : Page::work;
}

/// Opens the panel on each page that is read: a question, the list of lessons, a lesson's page, a new judgement. A
/// panel that a result opened closes when the weld continues or begins again.
void HeadsetFrontEnd::followPage(const LessonSession& session, const Home& home) {
    const Page before = std::exchange(page_, pageOf(session, home));
    const bool judged = std::exchange(judgements_, session.attempt().judgements()) != judgements_;
    const bool asked = session.question().asked();
    if (asked) panel_.show();
    switch (page_) {
    case Page::none:
        break;
    case Page::work:
        if (openedByResult_ && !asked) panel_.hide();
        openedByResult_ = false;
        break;
    case Page::home:
    case Page::lesson:
        if (page_ != before) panel_.show();
        openedByResult_ = false;
        break;
    case Page::result:
        if (!judged && before == Page::result) break;
        openedByResult_ |= !panel_.open();
        resultSeen_ = false;
        panel_.show();
        break;
    }
}

/// Returns true while the person burns the arc, or heats without one.
bool HeadsetFrontEnd::heats(const LessonSession& session) const {
    if (session.leader() != TorchLeader::hand || !session.running()) return false;
    const bool arc = session.lesson().model == LessonModel::Weld && isArcWelding(session.lesson().process);
    return arc ? session.welds() : hands_.torch().trigger() > 0;
}

/// Returns true while the torch, as the last frame left it, is where it welds: the panel beside the work, to which the
/// controller of an electrode holder is directed then, must not take the trigger.
bool HeadsetFrontEnd::torchWorks(const LessonSession& session) const {
    constexpr float kAtWork = 0.04f;                               // m
    if (session.lesson().model != LessonModel::Weld) return false; // its box is large, and no torch is held so
    if (page_ != Page::work || session.question().asked() || session.paused()) return false;
    if (session.leader() != TorchLeader::hand) return false;
    const std::optional<glm::vec3> end = torchEnd(session);
    return end && session.picture().toMetal(place_.toWorkpiece(*end)) * place_.zoom < kAtWork;
}

/// Closes the panel when an attempt's arc first burns, and moves it aside for the work.
void HeadsetFrontEnd::movePanel(const LessonSession& session, double elapsed) {
    const bool works = page_ == Page::work && !session.question().asked();
    if (works && !arcBurned_ && heats(session) && !panel_.pointer().pressed) {
        arcBurned_ = true;
        panel_.hide();
    }
    std::optional<glm::vec3> eyes;
    if (drawn_) {
        const xr::Pose here = workshop_.toWorkshop(head());
        eyes = here.position;
        resultSeen_ |= page_ == Page::result && faces(here, panel_.pose().position);
    }
    panel_.move(works, eyes, hands_.torchHand(), elapsed);
}

void HeadsetFrontEnd::holdAgain(const LessonSession& session, const xr::Input& input, double elapsed) {
    const xr::Hand other = hands_.torchHand() == xr::Hand::right ? xr::Hand::left : xr::Hand::right;
    const xr::HandInput& hand = input.hand(other);
    again_.update(hand.tracked && hand.trigger > 0.5f,
                  page_ == Page::result && !session.question().asked() && panel_.pointingHand() != other, elapsed);
}

/// Returns true if a hand has moved since the last call, or presses something.
bool HeadsetFrontEnd::handsAct(const xr::Input& input) {
    constexpr float kMoves = 0.003f; // m
    bool acts = false;
    for (const xr::Hand which : {xr::Hand::left, xr::Hand::right}) {
        const xr::HandInput& hand = input.hand(which);
        if (!hand.tracked) continue;
        glm::vec3& last = handPlaces_[size_t(which)];
        acts = acts || glm::distance(hand.grip.position, last) > kMoves || hand.trigger > 0.1f || hand.menu ||
               hand.recentre || std::abs(hand.scrollX) + std::abs(hand.scrollY) > 0.2f;
        last = hand.grip.position;
    }
    return acts;
}

/// Places the workshop in front of the person where that is due, but never while the hand's arc burns.
void HeadsetFrontEnd::placeWorkshop(LessonSession& session, double elapsed) {
    xr::Headset& headset = *connection_.headset();
    const xr::Input& input = headset.input();
    PersonInFrame person;
    if (drawn_) person.head = head();
    person.worn = headset.news().worn;
    person.spaceMoved = headset.news().spaceMoved;
    person.handsAct = handsAct(input);
    person.buttonHeld = input.hand(xr::Hand::left).recentre || input.hand(xr::Hand::right).recentre;
    placing_.update(person, workshop_, elapsed);
    if (!placing_.due() || hands_.torch().trigger() > 0) return;
    std::array<xr::EyeView, 2> eyes;
    if (!headset.locateEyes(eyes)) return;
    const xr::Pose here = middleOf(eyes);
    const bool set = parameters_.table == HeadsetParameters::kSetHeight;
    parameters_.tableHeight = workshop_.place(here, set ? std::optional(parameters_.setHeight) : std::nullopt,
                                              headset.session().originOnFloor());
    placing_.placed(here);
    panel_.forgetHeight();
    changes_.recentred(hands_, session);
}

TorchSource HeadsetFrontEnd::torch() {
    if (!leadsTorch()) return {};
    return [this](int step, int steps) { return hands_.next(place_, step, steps); };
}

MenuRequest HeadsetFrontEnd::draw(LessonSession& session, Home& home, const LessonFigures& figures,
                                  const Messages& messages, double elapsed, gl::Profiler* profiler) {
    if (!inFrame_) return MenuRequest::none;
    drawEyes(session, elapsed, profiler);
    recordPerson(session);
    if (inFrame_) drawNotice(session, figures, messages, elapsed);
    const MenuRequest asked = inFrame_ && panel_.open() ? drawMenu(session, home, figures, elapsed) : MenuRequest::none;
    return again_.asked() && asked == MenuRequest::none ? MenuRequest::reset : asked;
}

void HeadsetFrontEnd::drawEyes(LessonSession& session, double elapsed, gl::Profiler* profiler) {
    const SceneView scene = session.picture().scene(profiler);
    if (leadsTorch()) session.run().requestSurfaceDistance(hands_.sample(place_));
    const Clock::time_point start = Clock::now();
    guarded([&] {
        xr::Headset& headset = *connection_.headset();
        headset.beginFrame();
        drawn_ = false;
        mirror_.forgetFlat();
        view_.takeHands(hands_, panel_);
        if (timing_.shouldRender)
            drawn_ = headset.drawEyes(
                [&](const xr::BothEyes& eyes) { view_.draw(session, scene, place_, workshop_, eyes, profiler); });
        feedback_.update(session, hands_.torch(), parameters_.hapticStrength, elapsed);
        feedback_.play(headset, hands_);
    });
    sinceDark_ = view_.dark(session) ? 0 : sinceDark_ + elapsed;
    busy_ += std::chrono::duration<double>(Clock::now() - start).count();
}

/// Records head and hands of this frame.
void HeadsetFrontEnd::recordPerson(LessonSession& session) {
    if (!drawn_ || !inFrame_ || session.log().recordings().current() == nullptr) return;
    const auto inWorkpiece = [this](const xr::Pose& inSession) {
        const xr::Pose pose = workshop_.toWorkshop(inSession);
        return RecordingPose{place_.toWorkpiece(pose.position),
                             glm::normalize(place_.toWorkpiece(glm::normalize(pose.orientation)))};
    };
    xr::Headset& headset = *connection_.headset();
    RecordingPerson person;
    person.steps = session.run().steps();
    person.head = inWorkpiece(head());
    if (const auto& left = headset.input().hand(xr::Hand::left); left.tracked) person.left = inWorkpiece(left.grip);
    if (const auto& right = headset.input().hand(xr::Hand::right); right.tracked)
        person.right = inWorkpiece(right.grip);
    person.zoom = place_.zoom;
    session.log().recordings().person(person);
}

/// Returns the sentence for the notice's quiet part: the task until the arc has burned, as no one reads it beside a
/// pool, or the answer to a trigger held over a result.
std::string_view HeadsetFrontEnd::quietSentence(const LessonSession& session) const {
    if (again_.holds()) return phrase("headset.notice.again");
    const bool begins = page_ == Page::work && session.leader() == TorchLeader::hand && !arcBurned_;
    return begins ? std::string_view(session.lesson().text) : std::string_view();
}

xr::Pose HeadsetFrontEnd::head() const {
    return middleOf(connection_.headset()->views());
}

/// Leads the eyes to a result until they have seen it, and to the work until the attempt's arc has burned: the panel,
/// at eye height, was the last thing they saw.
std::string_view HeadsetFrontEnd::whereToLook(const LessonSession& session) const {
    if (drawn_ && page_ == Page::result && panel_.open() && !resultSeen_)
        return phrase("headset.notice.look_at_result");
    if (!drawn_ || arcBurned_ || page_ != Page::work || session.leader() != TorchLeader::hand) return {};
    return wayToWork(workshop_.toWorkshop(head()), place_.toWorkshop(glm::vec3(0)));
}

/// Place at which the torch works, in the workshop: that of a demonstration or replay, or the one in the hand; empty
/// while none is seen.
std::optional<glm::vec3> HeadsetFrontEnd::torchEnd(const LessonSession& session) const {
    if (session.running() && session.leader() == TorchLeader::path) return place_.toWorkshop(session.run().torchEnd());
    if (!hands_.torch().tracked()) return std::nullopt;
    return hands_.torch().end(place_.zoom * session.run().burntOff());
}

void HeadsetFrontEnd::drawNotice(const LessonSession& session, const LessonFigures& figures, const Messages& messages,
                                 double elapsed) {
    const std::string_view way = again_.holds() ? std::string_view() : whereToLook(session);
    const std::array<std::string_view, 2> lines{way, phrase("headset.notice.visor")};
    const size_t told = way.empty() ? 0 : page_ == Page::work && view_.visorDown(session) ? 2 : 1;
    notice_.text.compose(messages, figures, place_.zoom, way.empty() ? quietSentence(session) : std::string_view(),
                         std::span(lines).first(told));
    if (!drawn_ || notice_.text.text().empty()) return;
    guarded([&] {
        xr::Headset& headset = *connection_.headset();
        const bool nearTorch =
            !notice_.text.warnings().empty() || !figures.caption.empty() || again_.holds() || !way.empty();
        notice_.place.update(nearTorch, workshop_.toWorkshop(head()), torchEnd(session), parameters_.tableHeight,
                             elapsed, panel_.open() ? std::optional(panel_.pose()) : std::nullopt);
        const bool fresh = notice_.draw(headset.notice(), connection_.openings(), view_.dark(session), elapsed);
        const xr::Pose pose = workshop_.toSession(notice_.place.pose());
        headset.showNotice(pose, notice_.place.width(), fresh);
        mirror_.addFlat(headset.notice(), pose, notice_.place.width());
    });
}

MenuRequest HeadsetFrontEnd::drawMenu(LessonSession& session, Home& home, const LessonFigures& figures,
                                      double elapsed) {
    HeadsetMenuAnswer answer;
    guarded([&] {
        xr::Headset& headset = *connection_.headset();
        const xr::Panel& panel = headset.panel();
        answer = menu_.draw(panel, panel_.pointer(), elapsed, session,
                            {home, section_, warning(), hands_.tipReport(), hands_.tipMeasured(), figures,
                             hands_.torchHand() == xr::Hand::left,
                             page_ == Page::work && !panel_.pointingHand() && (heats(session) || view_.dark(session)),
                             question_});
        const xr::Pose pose = workshop_.toSession(panel_.pose());
        headset.showPanel(pose);
        mirror_.addFlat(panel, pose, panel.shape().width);
    });
    if (answer.recentre) placing_.request();
    if (answer.measureTip) hands_.measureTip();
    if (answer.measureAxis) hands_.measureAxis();
    if (answer.ownTip) hands_.useOwnTip();
    return answer.request;
}

void HeadsetFrontEnd::end() {
    if (!inFrame_) return;
    guarded([&] { connection_.headset()->endFrame(); });
    inFrame_ = false;
}

/// Returns true if the window shows the trainee's eye. Between two arcs of one weld the automatic choice stays with the
/// camera.
bool HeadsetFrontEnd::wantsMirror() const {
    constexpr double kBetweenArcs = 1.5; // s
    if (parameters_.deskView == HeadsetParameters::kByVisor) return sinceDark_ > kBetweenArcs;
    return parameters_.deskView == HeadsetParameters::kTrainee;
}

bool HeadsetFrontEnd::mirror(glm::ivec2 pixels, gl::ShaderLibrary& shaders) {
    mirrored_ = drawn_ && connection_.headset() != nullptr && wantsMirror();
    if (mirrored_) mirror_.draw(*connection_.headset(), pixels, shaders);
    return mirrored_;
}

std::string_view HeadsetFrontEnd::nextDeskView() {
    static constexpr std::array<std::string_view, 3> kSentences{
        "headset.desk_view.automatic", "headset.desk_view.trainee", "headset.desk_view.camera"};
    static constexpr std::array<int, 3> kNext{HeadsetParameters::kCamera, HeadsetParameters::kByVisor,
                                              HeadsetParameters::kTrainee};
    parameters_.deskView = kNext[static_cast<size_t>(parameters_.deskView)];
    return phrase(kSentences[static_cast<size_t>(parameters_.deskView)]);
}

std::optional<glm::vec3> HeadsetFrontEnd::arcFromHead(const LessonSession& session) const {
    if (!drawn_ || !session.running() || connection_.headset() == nullptr) return std::nullopt;
    return workshop_.toWorkshop(head()).inverse() * place_.toWorkshop(session.run().torchEnd());
}

std::string HeadsetFrontEnd::sentence() const {
    switch (connection_.state()) {
    case xr::ConnectionState::asleep:
        return phrase("headset.reason.asleep");
    case xr::ConnectionState::running:
        return phrase("headset.reason.in_use");
    case xr::ConnectionState::searching:
    case xr::ConnectionState::stalled:
    case xr::ConnectionState::ended:
        return connection_.reason();
    }
    return {};
}

std::string_view HeadsetFrontEnd::warning() const {
    switch (connection_.state()) {
    case xr::ConnectionState::searching:
        // Most desks have no runtime, so that needs no warning. A faulty file that should name one does.
        return connection_.openings() > 0 || connection_.manifestAtFault() ? std::string_view(connection_.reason())
                                                                           : std::string_view();
    case xr::ConnectionState::stalled:
        return connection_.reason();
    case xr::ConnectionState::running:
        // The runtime enables the input a few frames after the first picture.
        if (connection_.headset()->mode() != xr::SessionMode::focused && focusedOpening_ == connection_.openings())
            return phrase("headset.not_shown");
        return view_.dazzled().empty() ? hands_.warning() : view_.dazzled();
    case xr::ConnectionState::asleep:
    case xr::ConnectionState::ended:
        return {};
    }
    return {};
}

HeadsetStatus HeadsetFrontEnd::status() const {
    static constexpr std::array<const char*, 5> kStates{"searching", "asleep", "running", "stalled", "ended"};
    static constexpr std::array<const char*, 6> kModes{"waiting", "synchronized", "visible",
                                                       "focused", "ended",        "lost"};
    const xr::Headset* headset = connection_.headset();
    HeadsetStatus status;
    status.state = kStates[static_cast<size_t>(connection_.state())];
    if (headset != nullptr) status.mode = kModes[size_t(headset->mode())];
    status.mirrored = mirrored_;
    status.tipReport = hands_.tipReport();
    status.warning = warning();
    if (drawn_) status.notice = notice_.text.text();
    status.noticeAt = workshop_.toSession(notice_.place.pose()).position;
    status.endAt = workshop_.toSession({{1, 0, 0, 0}, notice_.place.end()}).position;
    status.openings = connection_.openings();
    status.tracked = hands_.torch().tracked();
    status.triggerLocked = hands_.torch().triggerLock().locked() || !changes_.lessonRuns();
    status.panel = panel_.open();
    const xr::Pose panel = workshop_.toSession(panel_.pose());
    status.panelAt = panel.position;
    status.panelTurn = panel.orientation;
    status.tip = feedback_.status(headset == nullptr ? 0 : headset->hapticCalls().applied);
    status.displayHz = timing_.period > 0 ? 1 / timing_.period : 0;
    status.busyMs = busy_ * 1000;
    status.places = menu_.places();
    return status;
}

} // namespace meltpool
