#include "app/desktop/desktop_lessons.hpp"

#include "app/activities/attempt_lesson.hpp"
#include "app/platform/open_file.hpp"
#include "app/session/attempt_page.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/words.hpp"
#include "core/training/lesson/lesson_folders.hpp"
#include "core/training/lesson/plausibility.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace meltpool {

void DesktopLessons::leave() {
    session_.end("start menu");
    controls_.restart();
    for (const std::string_view topic :
         std::array<std::string_view, 7>{"metal", "arc", "ghost", kSlowTopic, "record", "pause", "attempt"})
        messages_.clear(topic);
}

void DesktopLessons::goHome() {
    home_.attempts.hide();
    session_.activities().endComparison();
    if (home_.open) return;
    leave();
    home_.refresh();
    home_.choose(session_.lesson().key);
    home_.open = true;
}

/// Takes the opened lesson and gives it the values of the settings file; stores the values set in the lesson before.
void DesktopLessons::take(Lesson opened) {
    leave();
    settings_.takeFrom(session_.lesson(), session_.sections());
    session_.open(std::move(opened));
    settings_.giveTo(session_.lesson(), session_.sections());
    for (const std::string_view topic : {"lesson", "path form", "path"})
        messages_.clear(topic);
    home_.open = false;
}

void DesktopLessons::open(const CataloguedLesson& lesson, double now) {
    try {
        if (lesson.taken) throw InputError(lesson.fault);
        take(readLesson(lesson.file));
        tellPath(now);
    } catch (const InputError& fault) {
        messages_.warn(fault.what(), now, "lesson");
    }
}

void DesktopLessons::tellPath(double now) {
    const Lesson& lesson = session_.lesson();
    if (std::string form = pathFormText(lesson.torchFile.filename(), lesson.torch); !form.empty())
        messages_.note(std::move(form), now, "path form");
    std::string all;
    for (const std::string& sentence : pathWarnings(lesson))
        all += (all.empty() ? "" : " ") + sentence;
    if (!all.empty()) messages_.warn(std::move(all), now, "path");
}

bool DesktopLessons::start(void (LessonSession::*begin)(Controls&), double now) {
    if (home_.open) return false;
    if (const CataloguedLesson* lesson = home_.find(session_.lesson()))
        session_.attempt().cues().setSkill(home_.scores.beginAttempt(lesson->key));
    try {
        (session_.*begin)(controls_);
        return true;
    } catch (const std::exception& fault) {
        session_.end("the attempt could not begin");
        messages_.warn(fault.what(), now, "start");
        return false;
    }
}

/// Reports that the file of the attempt's lesson has changed since.
void DesktopLessons::tellMoved(const Lesson& attempt, double now) {
    if (!attempt.recorded) return;
    if (std::string moved = movedLessonText(*attempt.recorded, attempt); !moved.empty())
        messages_.note(std::move(moved), now, "lesson");
}

void DesktopLessons::openAttempt(const std::filesystem::path& file, double now, const std::string& lesson) {
    Lesson attempt = lessonOfAttempt(file, lesson);
    take(readLesson(attempt.file));
    if (lesson.empty()) tellMoved(attempt, now);
    session_.openReplay(std::move(attempt), controls_);
}

bool DesktopLessons::replay(const std::filesystem::path& file, double now) {
    try {
        openAttempt(file, now);
        return true;
    } catch (const std::exception& fault) {
        messages_.warn(fault.what(), now, "start");
        return false;
    }
}

bool DesktopLessons::weldBeside(const std::filesystem::path& file, double now) {
    try {
        const Lesson attempt = lessonOfAttempt(file);
        if (attempt.model != LessonModel::Weld || !attempt.ghost)
            throw InputError(file, 0,
                             "is an attempt at lesson '" + attempt.key +
                                 "', which allows no ghost; expected an attempt at a lesson with ghosts");
        take(readLesson(attempt.file));
        tellMoved(attempt, now);
        session_.attempt().ghost().choose(file);
    } catch (const std::exception& fault) {
        messages_.warn(fault.what(), now, "start");
        return false;
    }
    bool& forScore = session_.sections().attempt.forScore;
    if (std::exchange(forScore, false)) messages_.note(phrase("desk.message.practice_with_ghost"), now, "start");
    return start(&LessonSession::begin, now);
}

void DesktopLessons::compare(double now) {
    const auto& [first, second] = home_.attempts.pair();
    try {
        session_.compare({first.file, first.detail}, {second.file, second.detail});
    } catch (const std::exception& fault) {
        messages_.warn(phrase("desk.message.not_compared", {{"reason", fault.what()}}), now, "start");
    }
}

void DesktopLessons::tryCure(double now) {
    RecordingKeeper& recordings = session_.log().recordings();
    if (recordings.current() == nullptr) return;
    const std::filesystem::path file = recordings.file();
    goHome();
    recordings.finish(); // the file is read now
    home_.attempts.show();
    AttemptComparison::Side attempt{file, {}};
    for (const ReplayEntry& each : home_.attempts.entries())
        if (each.file == file) attempt.detail = each.detail;
    try {
        session_.compare(attempt);
    } catch (const std::exception& fault) {
        messages_.warn(phrase("desk.message.not_tried", {{"reason", fault.what()}}), now, "start");
    }
}

void DesktopLessons::showKeptPage(double now) {
    try {
        const std::filesystem::path page = keptAttemptPage(home_.attempts.chosen());
        openForPerson(page);
        messages_.note(phrase("desk.message.kept_page", {{"file", page.string()}}), now, "page");
    } catch (const std::exception& fault) {
        messages_.warn(phrase("desk.message.page_not_written", {{"reason", fault.what()}}), now, "page");
    }
}

void DesktopLessons::exportAttempts() {
    const std::filesystem::path table = home_.attempts.exportRows(keptFolder() / "tables");
    if (!table.empty()) openForPerson(table);
}

void DesktopLessons::keepScore(double zoom, double now) {
    zoom_ = zoom;
    const CataloguedLesson* lesson = home_.find(session_.lesson());
    if (lesson == nullptr || !session_.attempt().judged() || session_.log().redo().redone() > 0) return;
    std::optional<BestScore> score = countedScore(session_.attempt().judged()->judgement);
    if (!score) return;
    score->zoom = zoom;
    score->forScore = session_.sections().attempt.forScore;
    score->guided = session_.deskTorch().guided();
    score->swung = session_.deskTorch().weave().swung();
    score->changed = session_.values().workpieceChanged() || session_.values().settingsChanged();
    score->chosen = session_.values().chosenText();
    score->cues = session_.attempt().cues().used();
    score->ghost = session_.attempt().ghost().used();
    const std::vector<std::string>& faults = home_.scores.faults();
    const size_t told = faults.size();
    try {
        home_.scores.offer(lesson->key, *score);
        home_.scores.practise(lesson->key, session_.attempt().cues().skill());
    } catch (const std::exception& fault) {
        messages_.warn(phrase("desk.message.score_not_kept", {{"reason", fault.what()}}), now, "scores");
    }
    for (size_t i = told; i < faults.size(); ++i)
        messages_.warn(faults[i], now);
}

void DesktopLessons::writePage(const std::string& driver, double now) {
    try {
        const std::filesystem::path page = writeAttemptPage(session_, zoom_, driver);
        if (session_.leader() == TorchLeader::desk) openForPerson(page); // the headset cannot show a browser
        messages_.note(phrase("desk.message.page", {{"file", page.string()}}), now, "page");
    } catch (const std::exception& fault) {
        messages_.warn(phrase("desk.message.page_not_written", {{"reason", fault.what()}}), now, "page");
    }
}

} // namespace meltpool
