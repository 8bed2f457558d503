#include "app/headset/headset_desk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace meltpool {

namespace {

xr::HeadsetSettings settingsOf(const HeadsetParameters& parameters) {
    xr::HeadsetSettings settings;
    settings.resolutionScale = parameters.resolutionScale;
    settings.samples = parameters.samples;
    return settings;
}

std::optional<ViewSubmission> wantedSubmission(const HeadsetParameters& parameters) {
    if (parameters.bothEyes == HeadsetParameters::kAutomatic) return std::nullopt;
    return kViewSubmissions[static_cast<size_t>(parameters.bothEyes - HeadsetParameters::kViewports)];
}

View viewOf(const Workshop& workshop, const xr::EyeView& eye, const xr::BothEyes& eyes) {
    const xr::Pose pose = workshop.toWorkshop(eye.pose);
    return {pose.inverse().matrix(), xr::projection(eye.fov, eyes.nearZ, eyes.farZ), pose.position};
}

} // namespace

HeadsetDesk::HeadsetDesk(const HeadsetParameters& parameters, const std::filesystem::path& folder)
    : parameters_(parameters),
      calibrations_{CalibrationFile(folder / "torch-tip.txt"), CalibrationFile(folder / "torch-tip-tracker.txt")},
      link_(settingsOf(parameters)),
      place_(parameters, 0.0f) {}

/// A call on the headset that fails because the headset is gone ends the frame and nothing else.
void HeadsetDesk::guarded(FunctionRef<void()> work) {
    try {
        work();
    } catch (const xr::XrFault& fault) {
        inFrame_ = false;
        torch_.lose();
        link_.onFault(fault);
    } catch (const xr::Stalled&) {
        inFrame_ = false;
        torch_.lose();
        link_.onStall();
    }
}

bool HeadsetDesk::begin(float bottom, double elapsed) {
    inFrame_ = false;
    drawn_ = drawn_ && link_.headset() != nullptr;
    place_ = WorkpiecePlace(parameters_, bottom);
    time_ += elapsed;
    elapsed_ = elapsed;
    link_.use(settingsOf(parameters_)); // the settings file may have been read since
    if (link_.update() != xr::ConnectionState::running) {
        torch_.lose();
        drawn_ = drawn_ && link_.headset() != nullptr;
        return false;
    }
    guarded([&] {
        timing_ = link_.headset()->waitFrame();
        const Clock::time_point start = Clock::now();
        inFrame_ = true;
        readHands(elapsed);
        busy_ = std::chrono::duration<double>(Clock::now() - start).count();
    });
    return inFrame_;
}

void HeadsetDesk::readHands(double elapsed) {
    xr::Headset& headset = *link_.headset();
    torchHand_ = parameters_.hand == HeadsetParameters::kLeft ? xr::Hand::left : xr::Hand::right;
    for (const xr::Hand hand : {xr::Hand::left, xr::Hand::right})
        recentreAsked_ = recentreAsked_ || headset.input().hand(hand).recentre;
    placeWorkshop();
    placePanel();
    point();
    holdTorch(elapsed);
    const xr::HandInput& other = headset.input().hand(torchHand_ == xr::Hand::right ? xr::Hand::left : xr::Hand::right);
    rod_ = other.tracked ? std::optional(workshop_.toWorkshop(other.grip)) : std::nullopt;
    // A hand that works on the panel, or whose tip is being measured, does not weld.
    if (pointing_ || measuring_.underWay()) torch_.release();
    visor_.update(torch_.trigger() > 0, elapsed);
}

TorchSample HeadsetDesk::torch(int step, int steps) const {
    TorchSample sample = torch_.sample(place_, step, steps);
    if (rod_) {
        const glm::vec3 tip = *rod_ * glm::vec3(0, 0, -WorkshopScene::kRodReach);
        sample.rod = RodSample{place_.toWorkpiece(tip), glm::normalize(rod_->orientation)};
    }
    return sample;
}

void HeadsetDesk::holdTorch(double elapsed) {
    const xr::Input& input = link_.headset()->input();
    hold_.update(parameters_.torchOn == HeadsetParameters::kTracker, input.hand(torchHand_), input.trackers(), elapsed);
    if (hold_.changed()) torch_.lose();
    CalibrationFile& calibration = calibrations_[size_t(hold_.holder())];
    torch_.update(hold_.torch(), calibration.tip(), workshop_, elapsed);
    if (const auto measured = measuring_.gather(hold_.torch(), calibration.tip(), elapsed))
        measuring_.kept(calibration.keep(*measured));
}

void HeadsetDesk::placePanel() {
    const xr::Input& input = link_.headset()->input();
    for (const xr::Hand hand : {xr::Hand::left, xr::Hand::right}) {
        if (!input.hand(hand).menu) continue;
        panelOpen_ = !panelOpen_;
        pointingHand_ = hand;
    }
}

xr::Pose HeadsetDesk::panelPose() const {
    // Beside and behind the workpiece, away from the torch's hand, turned to where the person stands.
    const float side = torchHand_ == xr::Hand::right ? -1.0f : 1.0f;
    return {glm::angleAxis(-side * 0.48f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.2f, glm::vec3(1, 0, 0)),
            {side * 0.42f, parameters_.tableHeight + 0.45f, -0.35f}};
}

void HeadsetDesk::point() {
    pointer_ = {};
    pointing_ = false;
    if (!panelOpen_) return;
    const xr::Hand other = pointingHand_ == xr::Hand::left ? xr::Hand::right : xr::Hand::left;
    // The other hand takes over by pulling its trigger at the panel.
    if (pointWith(other) && pointer_.pressed)
        pointingHand_ = other;
    else
        pointWith(pointingHand_);
    pointing_ = pointer_.place.has_value() && pointingHand_ == torchHand_;
}

bool HeadsetDesk::pointWith(xr::Hand which) {
    pointer_ = {};
    const xr::PanelShape shape = panelShape();
    const xr::HandInput& hand = link_.headset()->input().hand(which);
    if (!hand.tracked) return false;
    const xr::Pose panel = panelPose();
    pointingRay_ = workshop_.toWorkshop(hand.aim);
    const std::optional<glm::vec2> place = xr::pointOnPanel(pointingRay_, panel, shape);
    if (!place) return false;
    pointer_ = {place, hand.trigger > 0.5f, hand.scrollY * 0.3f};
    const float metres = shape.width / static_cast<float>(shape.widthPixels);
    const glm::vec2 middle(float(shape.widthPixels) / 2, float(shape.heightPixels) / 2);
    const glm::vec2 local = (*place - middle) * metres;
    pointedAt_ = panel * glm::vec3(local.x, -local.y, 0.002f);
    return true;
}

void HeadsetDesk::showPanel(FunctionRef<void(GLuint, const PanelPointer&)> fill) {
    if (!panelShown()) return;
    guarded([&] {
        xr::Panel& panel = link_.headset()->panel();
        fill(panel.framebuffer(), pointer_);
        link_.headset()->showPanel(workshop_.toSession(panelPose()));
    });
}

void HeadsetDesk::placeWorkshop() {
    if (workshop_.placed() && !recentreAsked_) return;
    xr::Headset& headset = *link_.headset();
    std::array<xr::EyeView, 2> eyes;
    if (!headset.locateEyes(eyes)) return;
    const xr::Pose head = xr::interpolate(eyes[0].pose, eyes[1].pose, 0.5f);
    workshop_.recentre(head, parameters_, headset.session().originOnFloor());
    recentreAsked_ = false;
}

void HeadsetDesk::draw(Renderer& renderer, const LessonInSight& lesson, gl::Profiler* profiler) {
    if (!inFrame_) return;
    const Clock::time_point start = Clock::now();
    guarded([&] {
        link_.headset()->beginFrame();
        drawn_ = false; // what the runtime does not show is no mirror either
        if (timing_.shouldRender)
            drawn_ = link_.headset()->drawEyes(
                [&](const xr::BothEyes& eyes) { drawEyes(renderer, lesson, eyes, profiler); });
        vibrate(lesson);
    });
    busy_ += std::chrono::duration<double>(Clock::now() - start).count();
}

void HeadsetDesk::drawEyes(Renderer& renderer, const LessonInSight& lesson, const xr::BothEyes& eyes,
                           gl::Profiler* profiler) {
    HandsInSight hands;
    hands.torch = torch_.known();
    hands.tip = torch_.tip();
    hands.grip = torch_.grip();
    hands.heat = torch_.trigger();
    if (!panelOpen_) hands.rod = rod_;
    if (pointer_.place) {
        hands.rayStart = pointingRay_.position;
        hands.rayEnd = pointedAt_;
    }
    SceneView scene = *lesson.scene;
    if (scene.arc.intensity.g > 0)
        hands.arcGlow = scene.arc.intensity / (std::numbers::pi_v<float> * scene.arc.radius * scene.arc.radius);
    scene.modelToWorld = place_.modelToWorkshop(lesson.unit) * scene.modelToWorld;
    scene.solids = scene_.build(parameters_, hands);
    scene.source.shown = false; // the torch stands for it
    LookParameters look = *lesson.look;
    look.showBox = false;
    visor_.wear(parameters_, scene.temperature.kelvin, look);
    renderer.submitBy(wantedSubmission(parameters_));
    const std::array<View, 2> views{viewOf(workshop_, eyes.views[0], eyes), viewOf(workshop_, eyes.views[1], eyes)};
    renderer.draw(scene, look, views, {eyes.framebuffer, {0, 0, 2 * eyes.width, eyes.height}, eyes.encodesSrgb},
                  profiler);
}

unsigned HeadsetDesk::pulsesSent() const {
    return link_.headset() == nullptr ? 0 : link_.headset()->hapticCalls().applied;
}

void HeadsetDesk::vibrate(const LessonInSight& lesson) {
    sounding_ = lesson.sounding;
    if (torch_.tracked())
        touch_.update(lesson.gap, lesson.sounding, torch_.velocity(), elapsed_);
    else
        touch_.forget();
    feel_ = {time_, tipState(lesson.gap, lesson.handLeads ? torch_.trigger() : 0.0f, lesson.sounding), touch_.since(),
             touch_.speed()};
    feel_.state.liquid = lesson.sounding.liquid;
    vibration_ = feel(feel_);
    vibration_.amplitude *= parameters_.hapticStrength;
    // Whoever held the torch before feels nothing more of it.
    if (felt_ != hold_.holder() || feltHand_ != torchHand_) play({});
    felt_ = hold_.holder();
    feltHand_ = torchHand_;
    play(vibration_);
}

void HeadsetDesk::play(const Vibration& vibration) {
    const xr::HapticPulse pulse{vibration.amplitude, vibration.frequency, vibration.duration};
    if (felt_ == TorchHolder::tracker)
        link_.headset()->playTracker(hold_.tracker(), pulse);
    else
        link_.headset()->play(feltHand_, pulse);
}

void HeadsetDesk::end() {
    if (!inFrame_) return;
    guarded([&] { link_.headset()->endFrame(); });
    inFrame_ = false;
}

bool HeadsetDesk::mirror(GLuint framebuffer, const Viewport& viewport) const {
    const xr::Headset* headset = link_.headset();
    if (!drawn_ || headset == nullptr) return false;
    const xr::EyeTargets& eyes = headset->eyes();
    // The middle of the left eye's picture in the window's shape.
    const double aspect = double(viewport.width) / double(viewport.height);
    const int width = std::min(eyes.width(), int(eyes.height() * aspect));
    const int height = std::min(eyes.height(), int(width / aspect));
    const int x = (eyes.width() - width) / 2, y = (eyes.height() - height) / 2;
    glBlitNamedFramebuffer(eyes.resolved(), framebuffer, x, y, x + width, y + height, viewport.x, viewport.y,
                           viewport.x + viewport.width, viewport.y + viewport.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    return true;
}

std::string HeadsetDesk::sessionMode() const {
    static constexpr std::array<const char*, 6> kModes{"waiting", "synchronized", "visible",
                                                       "focused", "ended",        "lost"};
    return link_.headset() == nullptr ? "" : kModes[size_t(link_.headset()->mode())];
}

std::string HeadsetDesk::status() const {
    switch (link_.state()) {
    case xr::ConnectionState::searching:
        return link_.reason();
    case xr::ConnectionState::asleep:
        return "the headset sleeps; put it on";
    case xr::ConnectionState::running:
        return "the headset is in use";
    case xr::ConnectionState::stalled:
    case xr::ConnectionState::ended:
        return link_.reason();
    }
    return {};
}

std::string_view HeadsetDesk::warning() const {
    if (link_.state() == xr::ConnectionState::searching && link_.openings() > 0) return link_.reason();
    if (link_.state() == xr::ConnectionState::stalled) return link_.reason();
    if (link_.state() == xr::ConnectionState::running && link_.headset()->mode() != xr::SessionMode::focused)
        return "The headset shows something else than the trainer, so the arc is out.";
    if (link_.state() == xr::ConnectionState::running && !hold_.warning().empty()) return hold_.warning();
    if (link_.state() == xr::ConnectionState::running && torch_.known() && !torch_.tracked())
        return "The torch is out of sight: the arc is out. Hold it where the headset sees it.";
    return {};
}

} // namespace meltpool
