// Draws the result of an attempt: score, corrections, verdict and measured weld, for the window and the headset's
// panel.
#include "app/ui/panels.hpp"
#include "core/base/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace meltpool::ui {

namespace {

constexpr float kResultWidth = 430;
constexpr ImU32 kGood = IM_COL32(134, 214, 140, 255);
constexpr ImU32 kBad = IM_COL32(255, 138, 120, 255);

ImU32 tintOf(RowState state) {
    switch (state) {
    case RowState::good:
        return kGood;
    case RowState::bad:
        return kBad;
    case RowState::open:
        return colour::kWarning;
    case RowState::plain:
        break;
    }
    return colour::kText;
}

void wrapped(const std::string& text, ImU32 tint = colour::kText) {
    ImGui::PushStyleColor(ImGuiCol_Text, tint);
    wrappedText(text);
    ImGui::PopStyleColor();
}

/// Draws name and value on one line, the detail quietly below.
void drawRow(Context& context, const JudgementRow& row) {
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(row.name.c_str());
    ImGui::SameLine();
    const float x = right - ImGui::CalcTextSize(row.value.c_str()).x;
    if (x < ImGui::GetCursorPosX()) ImGui::NewLine(); // too long for one line
    ImGui::SetCursorPosX(std::max(x, 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Text, tintOf(row.state));
    ImGui::TextUnformatted(row.value.c_str());
    ImGui::PopStyleColor();
    if (row.detail.empty()) return;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - context.points(4)); // close to its name
    quietText(context, row.detail);
}

void drawSection(Context& context, const JudgementSection& section) {
    if (!namedHeading(context, "result", section.name, section.title)) return;
    if (!section.note.empty()) quietText(context, section.note);
    for (const JudgementRow& row : section.rows)
        drawRow(context, row);
}

/// Returns the worst place of the correction along the seam, m; empty if it has no place.
std::optional<double> worstPlace(const Judgement& judgement, const Correction& correction) {
    if (!correction.quantity || !judgement.score) return std::nullopt;
    const ParameterScore* parameter = judgement.score->find(*correction.quantity);
    if (parameter == nullptr || !std::isfinite(parameter->worstPlaceMm)) return std::nullopt;
    return parameter->worstPlaceMm * 1e-3;
}

/// Draws the first corrections; each one with a place has a button that goes back before it.
MenuRequest drawCorrections(Context& context, LessonSession& session) {
    static constexpr std::array<const char*, 3> kButtons{"result.redo.1", "result.redo.2", "result.redo.3"};
    const JudgedAttempt& attempt = *session.attempt().judged();
    const std::vector<Correction>& corrections = attempt.judgement.corrections;
    MenuRequest request = MenuRequest::none;
    if (attempt.rows.corrections.empty()) return request;
    ImGui::Dummy({0, context.points(4)});
    strongText(context, phrase("result.correction.heading"));
    for (size_t i = 0; i < attempt.rows.corrections.size(); ++i) {
        ImGui::Bullet();
        ImGui::SameLine();
        wrapped(attempt.rows.corrections[i]);
        if (i >= kButtons.size() || i >= corrections.size() || !session.redoes()) continue;
        const auto place = worstPlace(attempt.judgement, corrections[i]);
        if (!place || !button(context, kButtons[i], phrase("result.correction.redo").c_str(), ButtonKind::plain, 150,
                              phrase("result.correction.redo_tooltip").c_str()))
            continue;
        session.log().redo().choose(*place);
        request = MenuRequest::redo;
    }
    return request;
}

/// Draws the cures of the judged attempt; a chosen one is tried on its recording.
MenuRequest drawCures(Context& context, LessonSession& session) {
    const std::vector<CureRow>& cures = session.attempt().judged()->rows.cures;
    const auto chosen = curesPart(context, cures, session.log().recordings().current() != nullptr);
    if (!chosen) return MenuRequest::none;
    session.activities().comparison.choose(cures[*chosen].whatIf, cures[*chosen].change);
    return MenuRequest::tryCure;
}

MenuRequest drawJudgement(Context& context, LessonSession& session, const TechniqueBands* bands) {
    const JudgedAttempt& attempt = *session.attempt().judged();
    const JudgementRows& rows = attempt.rows;
    const MenuRequest tried = drawCures(context, session), corrected = drawCorrections(context, session);
    const MenuRequest request = tried != MenuRequest::none ? tried : corrected;
    for (const JudgementSection* section : {&rows.technique, &rows.judged, &rows.measured})
        if (!section->rows.empty() || section->note != rows.scoreNote) drawSection(context, *section);
    if (attempt.bend) bendPart(context, *attempt.bend);
    curvesPart(context, attempt.judgement, bands);
    ShortText moment;
    appendPhrase(moment, "result.note.moment", {{"seconds", PhraseNumber(attempt.time, 1)}});
    ImGui::Dummy({0, context.points(4)});
    quietText(context, moment);
    return request;
}

const TechniqueBands* bandsOf(const Lesson& lesson) {
    return lesson.technique ? &*lesson.technique : nullptr;
}

bool accepted(const LessonSession& session) {
    const auto& verdict = session.attempt().judged()->judgement.verdict;
    return verdict && verdict->accepted;
}

/// Best score of the session's lesson, of tests after a test; empty if there is none.
std::string bestText(LessonSession& session, const Home& home) {
    const CataloguedLesson* lesson = home.find(session.lesson());
    if (lesson == nullptr) return {};
    const bool test = session.values().forScore();
    const BestScore* best = test ? home.scores.findTest(lesson->key) : home.scores.find(lesson->key);
    return best == nullptr ? std::string() : bestScoreText(*best);
}

void verdictPart(Context& context, const JudgementRows& rows, ImFont& font) {
    ImGui::PushFont(&font);
    wrapped(rows.verdict, tintOf(rows.verdictState));
    ImGui::PopFont();
    if (!rows.verdictNote.empty()) quietText(context, rows.verdictNote);
}

} // namespace

std::optional<size_t> curesPart(Context& context, std::span<const CureRow> cures, bool tries) {
    std::optional<size_t> chosen;
    if (cures.empty()) return chosen;
    ImGui::Dummy({0, context.points(4)});
    strongText(context, phrase("cure.heading"));
    for (size_t i = 0; i < cures.size(); ++i) {
        ImGui::Bullet();
        ImGui::SameLine();
        wrapped(cures[i].sentence);
        ShortText name{"result.cure.", PhraseNumber(static_cast<double>(i + 1))};
        markItem(context, name);
        if (!tries || cures[i].whatIf.empty()) continue;
        name += ".try";
        ShortText note;
        appendPhrase(note, "cure.try_tooltip", {{"change", cures[i].change}});
        if (button(context, name, phrase("cure.try").c_str(), ButtonKind::plain, 190, note.c_str())) chosen = i;
    }
    return chosen;
}

float resultReach(const Context& context) {
    return context.points(kResultWidth + 10);
}

void resultHead(Context& context, LessonSession& session, const Home& home) {
    const JudgementRows& rows = session.attempt().judged()->rows;
    const std::string best = bestText(session, home);
    // Without a score the verdict is the news.
    const bool verdictFirst = !rows.scored && rows.verdictState != RowState::plain;
    if (verdictFirst) verdictPart(context, rows, *context.fonts.title);
    ImGui::PushFont(verdictFirst ? context.fonts.strong : context.fonts.title);
    ImGui::TextUnformatted(rows.score.c_str());
    ImGui::PopFont();
    markItem(context, "result.score");
    if (const std::string name = home.who.name(); !name.empty())
        quietText(context, phrase("persons.welder", {{"name", name}}));
    if (!best.empty()) quietText(context, best);
    if (session.log().redo().redone() > 0) quietText(context, phrase("result.note.practice"));
    quietText(context, rows.scoreNote);
    if (!verdictFirst) verdictPart(context, rows, *context.fonts.strong);
}

std::string_view brightResultButton(bool judged, bool accepted, bool hasNext) {
    if (!judged) return "result.judge";
    return accepted && hasNext ? "result.next" : "result.again";
}

MenuRequest resultPart(Context& context, LessonSession& session, const Home& home, ResultPlace place) {
    MenuRequest request = MenuRequest::none;
    const bool window = place == ResultPlace::window;
    if (window && session.attempt().judged()) resultHead(context, session, home);
    ButtonRow row(context, 10);
    const bool judged = session.attempt().judged().has_value();
    const CataloguedLesson* next = judged ? home.find(session.lesson().next) : nullptr;
    const std::string_view bright = brightResultButton(judged, judged && accepted(session), next != nullptr);
    const auto kind = [bright](std::string_view name) { return name == bright ? ButtonKind::main : ButtonKind::plain; };
    if (row.add("result.judge", phrase(judged ? "result.button.judge_again" : "result.button.judge").c_str(),
                kind("result.judge"), 150))
        request = MenuRequest::judge;
    if (row.add("result.again", phrase("result.button.again").c_str(), kind("result.again"), 110))
        request = MenuRequest::reset;
    ShortText homeNote;
    appendPhrase(homeNote, "result.tooltip.home", {{"key", context.key(Key::h)}});
    if (window && row.add("result.home", phrase("result.button.home").c_str(), ButtonKind::plain, 80, homeNote.c_str()))
        request = MenuRequest::home;
    if (next != nullptr) {
        ShortText text;
        appendPhrase(text, "result.button.next", {{"lesson", next->title}});
        if (button(context, "result.next", text.c_str(), kind("result.next"))) request = MenuRequest::next;
    }
    if (judged) {
        if (button(context, "result.page", phrase("result.button.page").c_str(), ButtonKind::plain, 80,
                   phrase("result.tooltip.page").c_str()))
            request = MenuRequest::page;
        if (session.picture().cut().shown() || session.cuts()) ImGui::SameLine();
    }
    if (const MenuRequest asked = cutPart(context, session); asked != MenuRequest::none) request = asked;
    if (session.redoes() && button(context, "result.redo", phrase("result.button.redo").c_str(), ButtonKind::plain, 110,
                                   phrase("result.tooltip.redo").c_str()))
        request = MenuRequest::redo;
    if (judged) {
        const MenuRequest asked = drawJudgement(context, session, bandsOf(session.lesson()));
        if (asked != MenuRequest::none) request = asked;
    } else if (session.run().arc().burns()) {
        quietText(context, phrase("result.note.arc_burns"));
    } else {
        quietText(context, phrase("result.note.not_judged"));
    }
    return request;
}

MenuRequest resultPanel(Context& context, LessonSession& session, const Home& home, bool fromTop) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = context.points(10);
    const float width = std::min(context.points(kResultWidth), screen.x - 2 * gap);
    ImGui::SetNextWindowPos({gap, barHeight(context) + gap});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - 2 * barHeight(context) - 2 * gap});
    ImGui::Begin("result", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    noteWindow(context, "result");
    if (fromTop) ImGui::SetScrollY(0);
    strongText(context, phrase("result.heading"));
    const MenuRequest request = resultPart(context, session, home, ResultPlace::window);
    ImGui::End();
    return request;
}

} // namespace meltpool::ui
