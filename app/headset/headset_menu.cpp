#include "app/headset/headset_menu.hpp"

#include "core/base/words.hpp"

#include <array>

namespace meltpool {

namespace {

ShortText figuresText(const LessonFigures& figures) {
    const double share = figures.particles > 0 ? 100.0 * double(figures.molten) / double(figures.particles) : 0;
    ShortText text;
    appendPhrase(text, "headset.figures",
                 {{"seconds", PhraseNumber(figures.time, 1)},
                  {"share", PhraseNumber(share, 1)},
                  {"hottest", ui::hottestText(figures)}});
    return text;
}

constexpr int kResult = 3; ///< number of the result page

bool plainButton(ui::Context& context, std::string_view name, std::string_view key, float width) {
    return ui::button(context, name, phrase(key).c_str(), ui::ButtonKind::plain, width);
}

bool group(ui::Context& context, std::string_view name, const char* title) {
    return ui::groupHeading(context, name, title, false);
}

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
        if (content.home.open) return homePart(context, session, content);
        lessonPart(context, session, content);
        pagePart(context, session, content);
    });
    return answer_;
}

/// Draws the list of lessons; below it, closed, the headset's parameters that can be set before a lesson.
void HeadsetMenu::homePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content) {
    ui::strongText(context, phrase("headset.lessons"));
    if (!content.warning.empty()) ui::quietText(context, content.warning);
    ImGui::Dummy({0, context.points(4)});
    if (const MenuRequest asked = ui::homePart(context, content.home, session.activities()); asked != MenuRequest::none)
        answer_.request = asked;
    answer_.recentre = plainButton(context, "headset.recentre", "headset.button.recentre", 140);
    if (group(context, "headset", "Headset")) headsetPage(context, content);
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
    if (content.question != nullptr && content.question->asked()) return ui::questionPart(context, *content.question);
    const Activities& activities = session.activities();
    if (activities.at(activities.demonstration))
        if (const MenuRequest asked = ui::demonstrationPart(context, session); asked != MenuRequest::none)
            answer_.request = asked;
    if (activities.at(activities.replay))
        if (const MenuRequest asked = ui::replayPart(context, session); asked != MenuRequest::none)
            answer_.request = asked;
    lessonButtons(context, session);
}

void HeadsetMenu::lessonButtons(ui::Context& context, const LessonSession& session) {
    const auto asks = [&](const char* name, const char* key, MenuRequest request, ui::ButtonKind kind, float width) {
        if (ui::button(context, name, phrase(key).c_str(), kind, width)) answer_.request = request;
        ImGui::SameLine();
    };
    if (!session.running()) {
        asks("headset.start", "headset.button.start", MenuRequest::start, ui::ButtonKind::main, 0);
        if (session.lesson().torch.duration() > 0)
            asks("headset.demonstration", "headset.button.demonstration", MenuRequest::demonstrate,
                 ui::ButtonKind::plain, 0);
    } else {
        asks("headset.reset", "headset.button.reset", MenuRequest::reset, ui::ButtonKind::plain, 96);
        asks("headset.restart", "headset.button.restart", MenuRequest::restart, ui::ButtonKind::plain, 96);
        if (session.activities().allowed().ownTorch && !session.picture().cut().shown())
            asks("headset.pause", session.paused() ? "headset.button.go_on" : "headset.button.pause",
                 MenuRequest::pause, ui::ButtonKind::plain, 96);
    }
    ImGui::NewLine();
    asks("headset.home", "headset.button.home", MenuRequest::home, ui::ButtonKind::plain, 70);
    answer_.recentre = plainButton(context, "headset.recentre", "headset.button.recentre", 130);
}

void HeadsetMenu::headsetPage(ui::Context& context, const HeadsetMenuContent& content) {
    drawParameters(context, content.section);
    answer_.measureTip = plainButton(context, "headset.tip", "headset.button.tip", 200);
    ImGui::SameLine();
    answer_.measureAxis = plainButton(context, "headset.axis", "headset.button.axis", 160);
    if (content.tipMeasured) answer_.ownTip = plainButton(context, "headset.own_tip", "headset.button.own_tip", 200);
    if (!content.tipReport.empty()) ui::quietText(context, content.tipReport);
}

void HeadsetMenu::pagePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content) {
    ImGui::Dummy({0, context.points(4)});
    static constexpr std::array<std::string_view, 4> kPages{"headset", "machine", "view", "result"};
    const bool judges = session.judges();
    if (session.attempt().judgements() != judgements_ || (page_ == kResult && !judges)) page_ = judges ? kResult : 0;
    judgements_ = session.attempt().judgements();
    ui::choiceRow(context, "headset.page", std::span(kPages).first(judges ? 4 : 3), page_);
    if (page_ == 0) headsetPage(context, content);
    if (page_ == kResult)
        if (const MenuRequest asked = ui::resultPart(context, session, content.home); asked != MenuRequest::none)
            answer_.request = asked;
    if (page_ == 1) {
        if (session.running())
            ui::machinePart(context, session.sections().simulation);
        else
            ui::setupPart(context, session);
    }
    if (page_ == 2) {
        if (session.lesson().model == LessonModel::Weld && group(context, "cues", "Cues at the torch"))
            drawParameters(context, session.help().cues);
        if (session.help().ghost.idle.empty() && group(context, "ghost", "Ghost torch"))
            drawParameters(context, session.help().ghost);
        drawParameters(context, session.sections().view);
        if (group(context, "sound", "Sound")) drawParameters(context, session.help().sound);
        if (group(context, "surface", "Expert")) drawParameters(context, session.sections().surface);
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
