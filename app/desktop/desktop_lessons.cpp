#include "app/desktop/desktop_lessons.hpp"

#include "core/base/error.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace meltpool {

void DesktopLessons::leave() {
    session_.end("start menu");
    controls_.restart();
    for (const std::string_view topic : std::array<std::string_view, 4>{"metal", "arc", kSlowTopic, "record"})
        messages_.clear(topic);
}

void DesktopLessons::goHome() {
    if (home_.open) return;
    leave();
    home_.choose(session_.lesson().key);
    home_.open = true;
}

void DesktopLessons::open(const CataloguedLesson& lesson, double now) {
    try {
        Lesson opened = loadLesson(lesson.key);
        leave();
        settings_.takeFrom(session_.lesson(), session_.sections());
        session_.open(std::move(opened));
        settings_.giveTo(session_.lesson(), session_.sections());
        messages_.clear("lesson");
        home_.open = false;
    } catch (const InputError& fault) {
        messages_.warn(fault.what(), now, "lesson");
    }
}

bool DesktopLessons::start(void (LessonSession::*begin)(Controls&), double now) {
    if (home_.open) return false;
    if (const CataloguedLesson* lesson = home_.find(session_.lesson()))
        session_.cues().setSkill(home_.scores.skill(lesson->key));
    try {
        (session_.*begin)(controls_);
        return true;
    } catch (const std::exception& fault) {
        session_.end("it could not begin");
        messages_.warn(fault.what(), now, "start");
        return false;
    }
}

void DesktopLessons::keepScore(double zoom, double now) {
    const CataloguedLesson* lesson = home_.find(session_.lesson());
    if (lesson == nullptr || !session_.judged()) return;
    std::optional<BestScore> score = countedScore(session_.judged()->judgement);
    if (!score) return;
    score->zoom = zoom;
    score->forScore = session_.sections().attempt.forScore;
    score->guided = session_.deskTorch().guided();
    score->changed = session_.workpieceChanged() || session_.settingsChanged();
    score->chosen = session_.chosenText();
    score->cues = session_.cues().used();
    try {
        home_.scores.offer(lesson->key, *score);
        home_.scores.practise(lesson->key, session_.cues().skill());
    } catch (const std::exception& fault) {
        messages_.warn(std::string("The best score cannot be kept: ") + fault.what(), now, "scores");
    }
}

} // namespace meltpool
