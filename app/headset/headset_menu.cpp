#include "app/headset/headset_menu.hpp"

#include "core/base/words.hpp"

#include <array>
#include <utility>

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

/// Pages in the order of their tabs.
enum Page { kMachine, kView, kHeadset, kResult };

void plainText(const std::string& text) {
    ImGui::TextWrapped("%s", text.c_str());
}

/// Returns the key of the sentence about the trigger of the torch's hand; null: before a lesson.
const char* triggerKey(const Lesson* lesson) {
    if (lesson == nullptr) return "headset.legend.trigger.press";
    if (lesson->model != LessonModel::Weld) return "headset.legend.trigger.heat";
    switch (traitsOf(lesson->process).torch) {
    case TorchShape::wireTorch:
        return "headset.legend.trigger.wire";
    case TorchShape::tungstenTorch:
        return "headset.legend.trigger.tungsten";
    case TorchShape::electrodeHolder:
        return "headset.legend.trigger.electrode";
    case TorchShape::burner:
        return "headset.legend.trigger.flame";
    case TorchShape::iron:
        break;
    }
    return "headset.legend.trigger.heat";
}

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
    const Shown now{content.home.open, session.running(), session.attempt().judgements()};
    judgedAnew_ = judgedAnew_ || now.judgements != shown_.judgements;
    const bool another = std::exchange(shown_, now) != now;
    panel_->draw(panel.framebuffer(), pointer, elapsed, [&](ui::Context& context) {
        if (another) ImGui::SetScrollY(0);
        if (content.home.open) return homePart(context, session, content);
        lessonPart(context, session, content);
        const bool asks = session.question().asked() || (content.question != nullptr && content.question->asked());
        const bool judged = session.attempt().judged().has_value(); // then its buttons come first
        if (!judged && !asks) legendPart(context, session, content);
        pagePart(context, session, content);
        if (judged && !asks) legendPart(context, session, content);
        if (content.dimmed)
            ui::fillRounded(*ImGui::GetForegroundDrawList(), {0, 0}, ImGui::GetIO().DisplaySize, IM_COL32(0, 0, 0, 120),
                            0);
    });
    return answer_;
}

/// Draws the list of lessons; below it, closed, the headset's parameters that can be set before a lesson.
void HeadsetMenu::homePart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content) {
    ui::strongText(context, phrase(content.home.who.asked() ? "persons.heading" : "headset.lessons"));
    if (!content.warning.empty()) ui::quietText(context, content.warning);
    if (!lessonSeen_ && !content.home.who.asked()) plainText(phrase("headset.how_to_press"));
    ImGui::Dummy({0, context.points(4)});
    if (const MenuRequest asked = ui::homePart(context, content.home, session.activities()); asked != MenuRequest::none)
        answer_.request = asked;
    answer_.recentre = plainButton(context, "headset.recentre", "headset.button.recentre", 140);
    if (!content.home.who.asked()) {
        ImGui::SameLine();
        ui::personsButton(context, content.home.who, false);
    }
    // Open until the first lesson; later by a press.
    if (ui::namedHeading(context, "headset", lessonSeen_ ? "buttons" : "first_buttons",
                         phrase("headset.legend.heading"), !lessonSeen_))
        legend(context, nullptr, content);
    if (group(context, "headset", "Headset")) headsetPage(context, content);
}

/// Draws the meaning of each hand's buttons; those of the torch's trigger in the words of `lesson`'s process, if there
/// is one.
void HeadsetMenu::legend(ui::Context& context, const Lesson* lesson, const HeadsetMenuContent& content) {
    ui::strongText(context, phrase(content.leftHanded ? "headset.legend.torch_left" : "headset.legend.torch_right"));
    plainText(phrase(triggerKey(lesson)));
    ui::strongText(context, phrase(content.leftHanded ? "headset.legend.other_right" : "headset.legend.other_left"));
    plainText(phrase(lesson != nullptr && lesson->model == LessonModel::Weld && holdsRod(lesson->process)
                         ? "headset.legend.rod"
                         : "headset.legend.other"));
    plainText(phrase("headset.legend.again"));
    plainText(phrase("headset.legend.menu"));
    plainText(phrase("headset.legend.stick"));
}

void HeadsetMenu::lessonPart(ui::Context& context, LessonSession& session, const HeadsetMenuContent& content) {
    lessonSeen_ = true;
    ui::strongText(context, session.lesson().title);
    if (session.attempt().judged())
        ui::resultHead(context, session, content.home);
    else
        plainText(session.lesson().text);
    if (session.running() && !session.attempt().judged()) ui::quietText(context, figuresText(content.figures));
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
        if (!session.attempt().judged()) // the result has its own
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

/// Draws the legend under a heading that opens it.
void HeadsetMenu::legendPart(ui::Context& context, const LessonSession& session, const HeadsetMenuContent& content) {
    if (ui::namedHeading(context, "headset", "lesson_buttons", phrase("headset.legend.heading"), false))
        legend(context, &session.lesson(), content);
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
    static constexpr std::array<std::string_view, 4> kPages{"machine", "view", "headset", "result"};
    const bool judges = session.judges();
    if (std::exchange(judgedAnew_, false) || (page_ == kResult && !judges)) page_ = judges ? kResult : kMachine;
    ui::choiceRow(context, "headset.page", std::span(kPages).first(judges ? 4 : 3), page_);
    if (page_ == kHeadset) headsetPage(context, content);
    if (page_ == kResult)
        if (const MenuRequest asked = ui::resultPart(context, session, content.home, ui::ResultPlace::panel);
            asked != MenuRequest::none)
            answer_.request = asked;
    if (page_ == kMachine) {
        if (session.running())
            ui::machinePart(context, session.sections());
        else
            ui::setupPart(context, session);
    }
    if (page_ == kView) {
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
