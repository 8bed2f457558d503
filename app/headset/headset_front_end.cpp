#include "app/headset/headset_front_end.hpp"

#include <algorithm>
#include <array>

namespace meltpool {

namespace {

xr::HeadsetSettings settingsOf(const HeadsetParameters& parameters) {
    xr::HeadsetSettings settings;
    settings.resolutionScale = parameters.resolutionScale;
    settings.samples = parameters.samples;
    return settings;
}

} // namespace

HeadsetFrontEnd::HeadsetFrontEnd(const std::filesystem::path& folder)
    : section_("headset", describe(parameters_)),
      connection_(settingsOf(parameters_)),
      place_(parameters_, 0.0f),
      hands_(parameters_, folder),
      panel_(parameters_),
      view_(parameters_) {}

/// Ends the headset's frame where a call on it fails or is given up; the window continues without it.
void HeadsetFrontEnd::guarded(FunctionRef<void()> work) {
    try {
        work();
    } catch (const xr::XrFault& fault) {
        inFrame_ = false;
        hands_.lose();
        connection_.onFault(fault);
    } catch (const xr::Stalled&) {
        inFrame_ = false;
        hands_.lose();
        connection_.onStall();
    }
}

bool HeadsetFrontEnd::begin(const LessonSession& session, double elapsed) {
    inFrame_ = false;
    mirrored_ = false;
    place_ = WorkpiecePlace(parameters_, session.bottom());
    connection_.use(settingsOf(parameters_)); // the settings file may have been read since the start
    const bool runs = connection_.update() == xr::ConnectionState::running;
    drawn_ = drawn_ && connection_.headset() != nullptr;
    if (!runs) {
        hands_.lose();
        return false;
    }
    guarded([&] {
        timing_ = connection_.headset()->waitFrame();
        const Clock::time_point start = Clock::now();
        inFrame_ = true;
        readHands(elapsed);
        busy_ = std::chrono::duration<double>(Clock::now() - start).count();
    });
    return inFrame_;
}

void HeadsetFrontEnd::readHands(double elapsed) {
    xr::Headset& headset = *connection_.headset();
    const xr::Input& input = headset.input();
    if (input.hand(xr::Hand::left).recentre || input.hand(xr::Hand::right).recentre) workshop_.requestRecentre();
    placeWorkshop();
    panel_.update(input, workshop_, headset.panel().shape(), hands_.torchHand());
    hands_.update(input, workshop_, elapsed);
    if (panel_.pointingHand() == hands_.torchHand()) hands_.releaseTrigger();
    view_.update(hands_.torch(), elapsed);
}

void HeadsetFrontEnd::placeWorkshop() {
    if (!workshop_.recentreRequested()) return;
    xr::Headset& headset = *connection_.headset();
    std::array<xr::EyeView, 2> eyes;
    if (!headset.locateEyes(eyes)) return;
    const xr::Pose head = xr::interpolate(eyes[0].pose, eyes[1].pose, 0.5f);
    workshop_.recentre(head, parameters_, headset.session().originOnFloor());
}

TorchSource HeadsetFrontEnd::torch() const {
    if (!leadsTorch()) return {};
    return [this](int step, int steps) { return hands_.sample(place_, step, steps); };
}

MenuRequest HeadsetFrontEnd::draw(LessonSession& session, const LessonFigures& figures, double elapsed,
                                  gl::Profiler* profiler) {
    if (!inFrame_) return MenuRequest::none;
    drawEyes(session, elapsed, profiler);
    return inFrame_ && panel_.open() ? drawMenu(session, figures, elapsed) : MenuRequest::none;
}

void HeadsetFrontEnd::drawEyes(LessonSession& session, double elapsed, gl::Profiler* profiler) {
    const SceneView scene = session.scene(profiler);
    if (leadsTorch()) session.sound(hands_.sample(place_, 0, 1));
    const Clock::time_point start = Clock::now();
    guarded([&] {
        xr::Headset& headset = *connection_.headset();
        headset.beginFrame();
        drawn_ = false;
        view_.takeHands(hands_, panel_);
        if (timing_.shouldRender)
            drawn_ = headset.drawEyes(
                [&](const xr::BothEyes& eyes) { view_.draw(session, scene, place_, workshop_, eyes, profiler); });
        feedback_.update(session, hands_.torch(), parameters_.hapticStrength, elapsed);
        feedback_.play(headset, hands_);
    });
    busy_ += std::chrono::duration<double>(Clock::now() - start).count();
}

MenuRequest HeadsetFrontEnd::drawMenu(LessonSession& session, const LessonFigures& figures, double elapsed) {
    HeadsetMenuAnswer answer;
    guarded([&] {
        xr::Headset& headset = *connection_.headset();
        const xr::Panel& panel = headset.panel();
        answer =
            menu_.draw(panel, panel_.pointer(), elapsed, session, {section_, warning(), hands_.tipReport(), figures});
        headset.showPanel(workshop_.toSession(panel_.pose()));
    });
    if (answer.recentre) workshop_.requestRecentre();
    if (answer.measureTip) hands_.measureTip();
    if (answer.measureAxis) hands_.measureAxis();
    return answer.request;
}

void HeadsetFrontEnd::end() {
    if (!inFrame_) return;
    guarded([&] { connection_.headset()->endFrame(); });
    inFrame_ = false;
}

bool HeadsetFrontEnd::mirror(glm::ivec2 pixels) {
    mirrored_ = parameters_.deskView == HeadsetParameters::kTrainee && blitLeftEye(pixels);
    return mirrored_;
}

bool HeadsetFrontEnd::blitLeftEye(glm::ivec2 pixels) const {
    const xr::Headset* headset = connection_.headset();
    if (!drawn_ || headset == nullptr) return false;
    const xr::EyeTargets& eyes = headset->eyes();
    // The middle of the left eye's picture in the window's shape.
    const double aspect = double(pixels.x) / double(pixels.y);
    const int width = std::min(eyes.width(), int(eyes.height() * aspect));
    const int height = std::min(eyes.height(), int(width / aspect));
    const int x = (eyes.width() - width) / 2, y = (eyes.height() - height) / 2;
    glBlitNamedFramebuffer(eyes.resolved(), 0, x, y, x + width, y + height, 0, 0, pixels.x, pixels.y,
                           GL_COLOR_BUFFER_BIT, GL_LINEAR);
    return true;
}

std::string HeadsetFrontEnd::sentence() const {
    switch (connection_.state()) {
    case xr::ConnectionState::asleep:
        return "the headset sleeps; put it on";
    case xr::ConnectionState::running:
        return "the headset is in use";
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
        return connection_.openings() > 0 ? std::string_view(connection_.reason()) : std::string_view();
    case xr::ConnectionState::stalled:
        return connection_.reason();
    case xr::ConnectionState::running:
        if (connection_.headset()->mode() != xr::SessionMode::focused)
            return "The headset shows something else than the trainer, so the arc is out.";
        return hands_.warning();
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
    status.openings = connection_.openings();
    status.tracked = hands_.torch().tracked();
    status.panel = panel_.open();
    status.tip = feedback_.status(headset == nullptr ? 0 : headset->hapticCalls().applied);
    status.busyMs = busy_ * 1000;
    status.places = menu_.places();
    return status;
}

} // namespace meltpool
