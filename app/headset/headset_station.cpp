#include "app/headset/headset_station.hpp"

#include <array>
#include <cstdio>

namespace meltpool {

namespace {

ui::ShortText figuresText(const LessonFigures& figures) {
    std::array<char, 128> text{};
    const double share = figures.particles > 0 ? 100.0 * double(figures.molten) / double(figures.particles) : 0;
    std::snprintf(text.data(), text.size(), "%.1f s   \xC2\xB7   %.1f %% molten   \xC2\xB7   hottest %.2f",
                  figures.time, share, figures.hottest);
    return text.data();
}

void drawParameters(ui::Context& context, const ParameterSection& section) {
    for (const Parameter& parameter : section.parameters)
        if (!parameter.onlyAtStart) ui::parameterControl(context, section.name, parameter, section.defaults);
}

} // namespace

HeadsetStation::HeadsetStation(const std::filesystem::path& folder)
    : section_("headset", describe(parameters_)), desk_(parameters_, folder) {}

HeldTorchAt HeadsetStation::torch() const {
    if (!desk_.leadsTorch()) return {};
    return [this](int step, int steps) { return desk_.torch(step, steps); };
}

MenuRequest HeadsetStation::draw(Session& session, const LessonFigures& figures, double elapsed,
                                 gl::Profiler* profiler) {
    mirrored_ = false;
    if (!desk_.inFrame()) return MenuRequest::none;
    const SceneView scene = session.scene(profiler);
    if (desk_.leadsTorch()) session.sound(desk_.torch(0, 1));
    desk_.draw(session.renderer(),
               {&scene, &session.lesson().look, session.unit(), session.held(), session.gap(), session.sounding()},
               profiler);
    return desk_.panelShown() ? drawPanel(session, figures, elapsed) : MenuRequest::none;
}

MenuRequest HeadsetStation::drawPanel(Session& session, const LessonFigures& figures, double elapsed) {
    const xr::PanelShape shape = desk_.panelShape();
    if (panel_ == nullptr) panel_ = std::make_unique<HeadsetPanel>(shape.widthPixels, shape.heightPixels);
    MenuRequest request = MenuRequest::none;
    desk_.showPanel([&](GLuint framebuffer, const PanelPointer& pointer) {
        panel_->draw(framebuffer, pointer, elapsed,
                     [&](ui::Context& context) { request = panelContent(context, session, figures); });
    });
    return request;
}

MenuRequest HeadsetStation::panelContent(ui::Context& context, Session& session, const LessonFigures& figures) {
    MenuRequest request = MenuRequest::none;
    ui::strongText(context, session.lesson().title);
    if (session.running())
        ui::quietText(context, figuresText(figures));
    else
        ui::quietText(context, session.lesson().text);
    if (!desk_.warning().empty()) ui::quietText(context, desk_.warning());
    ImGui::Dummy({0, context.points(4)});
    if (!session.running()) {
        if (ui::button(context, "headset.start", "Start the lesson", ui::ButtonKind::main))
            request = MenuRequest::start;
    } else {
        if (ui::button(context, "headset.reset", "Reset", ui::ButtonKind::plain, 90)) request = MenuRequest::reset;
        ImGui::SameLine();
        if (ui::button(context, "headset.restart", "Start menu", ui::ButtonKind::plain, 110))
            request = MenuRequest::restart;
        ImGui::SameLine();
    }
    if (ui::button(context, "headset.recentre", "Workshop here", ui::ButtonKind::plain, 140)) desk_.recentre();
    ImGui::Dummy({0, context.points(4)});
    static constexpr std::array<std::string_view, 3> kPages{"headset", "simulation", "view"};
    ui::choiceRow(context, "headset.page", kPages, page_);
    if (page_ == 0) {
        drawParameters(context, section_);
        if (ui::button(context, "headset.tip", "Measure the torch's tip", ui::ButtonKind::plain, 200))
            desk_.measureTip();
        ImGui::SameLine();
        if (ui::button(context, "headset.axis", "and its direction", ui::ButtonKind::plain, 160)) desk_.measureAxis();
        if (!desk_.tipReport().empty()) ui::quietText(context, desk_.tipReport());
    }
    if (page_ == 1) drawParameters(context, session.sections().simulation);
    if (page_ == 2) {
        drawParameters(context, session.sections().view);
        drawParameters(context, session.sections().surface);
    }
    return request;
}

bool HeadsetStation::mirror(glm::ivec2 pixels) {
    mirrored_ = parameters_.deskView == HeadsetParameters::kTrainee && desk_.mirror(0, {0, 0, pixels.x, pixels.y});
    return mirrored_;
}

TipStatus HeadsetStation::tipStatus() const {
    static constexpr std::array<const char*, 5> kActions{"idle", "burning", "shorting", "stubbed", "breaking"};
    TipStatus status;
    status.action = kActions[static_cast<size_t>(desk_.tipFeel().state.action)];
    status.aheadMm = 1000.0 * static_cast<double>(desk_.sounding().ahead);
    status.nearestMm = 1000.0 * static_cast<double>(desk_.sounding().nearest);
    status.liquid = static_cast<double>(desk_.sounding().liquid);
    status.touching = desk_.touch().touching();
    status.touches = desk_.touch().count();
    status.amplitude = static_cast<double>(desk_.vibration().amplitude);
    status.frequency = static_cast<double>(desk_.vibration().frequency);
    status.pulses = desk_.pulsesSent();
    return status;
}

HeadsetStatus HeadsetStation::status() const {
    static constexpr std::array<const char*, 5> kStates{"searching", "asleep", "running", "stalled", "ended"};
    HeadsetStatus status;
    status.state = kStates[static_cast<size_t>(desk_.state())];
    status.mode = desk_.sessionMode();
    status.mirrored = mirrored_;
    status.tipReport = desk_.tipReport();
    status.warning = desk_.warning();
    status.openings = desk_.openings();
    status.tracked = desk_.heldTorch().tracked();
    status.panel = desk_.panelOpen();
    status.tip = tipStatus();
    status.busyMs = desk_.busySeconds() * 1000;
    if (panel_ != nullptr)
        for (const auto& [name, place] : panel_->context().places)
            if (panel_->context().inSight(place)) status.places.emplace(name, place);
    return status;
}

} // namespace meltpool
