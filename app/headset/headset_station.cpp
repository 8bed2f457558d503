#include "app/headset/headset_station.hpp"

#include <array>
#include <cstdio>

namespace meltpool {

namespace {

ui::Section sectionOf(HeadsetParameters& parameters) {
    ui::Section made{"headset", describe(parameters), {}};
    made.defaults = ui::defaultTexts(made.parameters);
    return made;
}

ui::ShortText figuresText(const ui::Figures& figures) {
    std::array<char, 128> text{};
    const double share = figures.particles > 0 ? 100.0 * double(figures.molten) / double(figures.particles) : 0;
    std::snprintf(text.data(), text.size(), "%.1f s   \xC2\xB7   %.1f %% molten   \xC2\xB7   hottest %.2f",
                  figures.time, share, figures.hottest);
    return text.data();
}

void drawParameters(ui::Context& context, const ui::Section& section) {
    for (const Parameter& parameter : section.parameters)
        if (!parameter.onlyAtStart) ui::parameterControl(context, section.name, parameter, section.defaults);
}

} // namespace

HeadsetStation::HeadsetStation(const std::filesystem::path& folder)
    : section_(sectionOf(parameters_)), desk_(parameters_, folder) {}

HeldTorchAt HeadsetStation::torch() const {
    if (!desk_.leadsTorch()) return {};
    return [this](int step, int steps) { return desk_.torch(step, steps); };
}

ui::Request HeadsetStation::draw(Session& session, const ui::Figures& figures, double elapsed, gl::Profiler* profiler) {
    mirrored_ = false;
    if (!desk_.inFrame()) return ui::Request::none;
    const SceneView scene = session.scene(profiler);
    if (desk_.leadsTorch()) session.sound(desk_.torch(0, 1));
    desk_.draw(session.renderer(),
               {&scene, &session.lesson().look, session.unit(), session.held(), session.gap(), session.sounding()},
               profiler);
    return desk_.panelShown() ? drawPanel(session, figures, elapsed) : ui::Request::none;
}

ui::Request HeadsetStation::drawPanel(Session& session, const ui::Figures& figures, double elapsed) {
    const xr::PanelShape shape = desk_.panelShape();
    if (panel_ == nullptr) panel_ = std::make_unique<HeadsetPanel>(shape.widthPixels, shape.heightPixels);
    ui::Request request = ui::Request::none;
    desk_.showPanel([&](GLuint framebuffer, const PanelPointer& pointer) {
        panel_->draw(framebuffer, pointer, elapsed,
                     [&](ui::Context& context) { request = panelContent(context, session, figures); });
    });
    return request;
}

ui::Request HeadsetStation::panelContent(ui::Context& context, Session& session, const ui::Figures& figures) {
    ui::Request request = ui::Request::none;
    ui::strongText(context, session.lesson().title);
    if (session.running())
        ui::quietText(context, figuresText(figures));
    else
        ui::quietText(context, session.lesson().text);
    if (!desk_.warning().empty()) ui::quietText(context, desk_.warning());
    ImGui::Dummy({0, context.points(4)});
    if (!session.running()) {
        if (ui::button(context, "headset.start", "Start the lesson", ui::ButtonKind::main))
            request = ui::Request::start;
    } else {
        if (ui::button(context, "headset.reset", "Reset", ui::ButtonKind::plain, 90)) request = ui::Request::reset;
        ImGui::SameLine();
        if (ui::button(context, "headset.restart", "Start menu", ui::ButtonKind::plain, 110))
            request = ui::Request::restart;
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

TipTold HeadsetStation::toldOfTip() const {
    static constexpr std::array<const char*, 5> kActions{"idle", "burning", "shorting", "stubbed", "breaking"};
    TipTold told;
    told.action = kActions[static_cast<size_t>(desk_.tipFeel().state.action)];
    told.aheadMm = 1000.0 * static_cast<double>(desk_.sounding().ahead);
    told.nearestMm = 1000.0 * static_cast<double>(desk_.sounding().nearest);
    told.liquid = static_cast<double>(desk_.sounding().liquid);
    told.touching = desk_.touch().touching();
    told.touches = desk_.touch().count();
    told.amplitude = static_cast<double>(desk_.vibration().amplitude);
    told.frequency = static_cast<double>(desk_.vibration().frequency);
    told.pulses = desk_.pulsesSent();
    return told;
}

HeadsetTold HeadsetStation::told() const {
    static constexpr std::array<const char*, 5> kStates{"searching", "asleep", "running", "stalled", "ended"};
    HeadsetTold told;
    told.state = kStates[static_cast<size_t>(desk_.state())];
    told.mode = desk_.sessionMode();
    told.mirrored = mirrored_;
    told.tipReport = desk_.tipReport();
    told.warning = desk_.warning();
    told.openings = desk_.openings();
    told.tracked = desk_.heldTorch().tracked();
    told.panel = desk_.panelOpen();
    told.tip = toldOfTip();
    told.busyMs = desk_.busySeconds() * 1000;
    if (panel_ != nullptr)
        for (const auto& [name, place] : panel_->context().places)
            if (panel_->context().inSight(place)) told.places.emplace(name, place);
    return told;
}

} // namespace meltpool
