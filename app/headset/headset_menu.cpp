#include "app/headset/headset_menu.hpp"

#include <array>
#include <cstdio>

namespace meltpool {

namespace {

ui::ShortText figuresText(const LessonFigures& figures) {
    std::array<char, 128> text{};
    const double share = figures.particles > 0 ? 100.0 * double(figures.molten) / double(figures.particles) : 0;
    std::snprintf(text.data(), text.size(), "%.1f s   \xC2\xB7   %.1f %% molten   \xC2\xB7   hottest ", figures.time,
                  share);
    return {text.data(), ui::hottestText(figures)};
}

constexpr int kResult = 3; ///< the page

void drawParameters(ui::Context& context, const ParameterSection& section) {
    for (const Parameter& parameter : section.parameters)
        if (!parameter.onlyAtStart && section.shows(parameter))
            ui::parameterControl(context, section.name, parameter, section.defaults);
}

} // namespace

HeadsetMenuAnswer HeadsetMenu::draw(const xr::Panel& panel, const PointerOnPanel& pointer, double elapsed,
                                    LessonSession& session, const HeadsetMenuContent& content) {
    if (panel_ == nullptr)
        panel_ = std::make_unique<HeadsetPanel>(panel.shape().widthPixels, panel.shape().heightPixels);
    answer_ = {};
    panel_->draw(panel.framebuffer(), pointer, elapsed, [&](ui::Context& context) {
        lessonPart(context, session, content);
        pagePart(context, session, content);
    });
    return answer_;
}

void HeadsetMenu::lessonPart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content) {
    ui::strongText(context, session.lesson().title);
    if (session.running())
        ui::quietText(context, figuresText(content.figures));
    else
        ui::quietText(context, session.lesson().text);
    if (!content.warning.empty()) ui::quietText(context, content.warning);
    ImGui::Dummy({0, context.points(4)});
    if (session.question().asked()) return ui::questionPart(context, session.question());
    if (!session.running()) {
        if (ui::button(context, "headset.start", "Start the lesson", ui::ButtonKind::main))
            answer_.request = MenuRequest::start;
    } else {
        if (ui::button(context, "headset.reset", "Reset", ui::ButtonKind::plain, 90))
            answer_.request = MenuRequest::reset;
        ImGui::SameLine();
        if (ui::button(context, "headset.restart", "Start menu", ui::ButtonKind::plain, 110))
            answer_.request = MenuRequest::restart;
        ImGui::SameLine();
    }
    answer_.recentre = ui::button(context, "headset.recentre", "Workshop here", ui::ButtonKind::plain, 140);
}

void HeadsetMenu::pagePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content) {
    ImGui::Dummy({0, context.points(4)});
    static constexpr std::array<std::string_view, 4> kPages{"headset", "simulation", "view", "result"};
    const bool judges = session.judges();
    if (session.judgements() != judgements_ || (page_ == kResult && !judges)) page_ = judges ? kResult : 0;
    judgements_ = session.judgements();
    ui::choiceRow(context, "headset.page", std::span(kPages).first(judges ? 4 : 3), page_);
    if (page_ == 0) {
        drawParameters(context, content.section);
        answer_.measureTip = ui::button(context, "headset.tip", "Measure the torch's tip", ui::ButtonKind::plain, 200);
        ImGui::SameLine();
        answer_.measureAxis = ui::button(context, "headset.axis", "and its direction", ui::ButtonKind::plain, 160);
        if (!content.tipReport.empty()) ui::quietText(context, content.tipReport);
    }
    if (page_ == kResult)
        if (const MenuRequest asked = ui::resultPart(context, session); asked != MenuRequest::none)
            answer_.request = asked;
    if (page_ == 1) drawParameters(context, session.sections().simulation);
    if (page_ == 2) {
        drawParameters(context, session.sections().view);
        drawParameters(context, session.sections().surface);
    }
}

std::map<std::string, ui::Place> HeadsetMenu::places() const {
    std::map<std::string, ui::Place> shown;
    if (panel_ == nullptr) return shown;
    for (const auto& [name, place] : panel_->context().places)
        if (panel_->context().shown(place)) shown.emplace(name, place);
    return shown;
}

} // namespace meltpool
