#include "app/session/attempt_page.hpp"

#include "app/platform/program_info.hpp"
#include "app/report/attempt_pictures.hpp"
#include "app/report/record_results.hpp"
#include "app/report/report_page.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson_folders.hpp"

#include <algorithm>
#include <chrono>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 960, kHeight = 540, kSamples = 4;

/// The picture "metal"; if there is none, the first that is no section.
const PictureLook* outsideOf(const std::vector<PictureLook>& pictures) {
    const auto named = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return p.name == "metal"; });
    if (named != pictures.end()) return &*named;
    const auto first = std::find_if(pictures.begin(), pictures.end(), [](const auto& p) { return !p.sectionAt; });
    return first == pictures.end() ? nullptr : &*first;
}

std::vector<ReportPicture> picturesOf(LessonScene& scene, Renderer& renderer) {
    std::vector<ReportPicture> taken;
    const std::vector<PictureLook>& pictures = scene.trainer().lesson().pictures;
    const PictureLook* outside = outsideOf(pictures);
    const PictureTarget target(kWidth, kHeight, kSamples);
    scene.updateSurface(nullptr);
    for (const PictureLook& picture : pictures)
        if (&picture == outside || picture.sectionAt)
            taken.push_back({picture.name, pngBytes(takePicture(renderer, target, scene, picture))});
    return taken;
}

fs::path freeName(const fs::path& wanted) {
    fs::path name = wanted;
    std::error_code failure;
    for (int number = 2; fs::exists(fs::symlink_status(name, failure)); ++number)
        name.replace_filename(wanted.stem().string() + " (" + std::to_string(number) + ")" +
                              wanted.extension().string());
    return name;
}

/// The user's folder of pages; makes it if it is missing.
fs::path pagesFolder() {
    const fs::path folder = keptFolder() / "pages";
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure || !fs::is_directory(folder, failure))
        throw InputError(folder, 0, "cannot be created; expected a parent folder with write permission");
    return folder;
}

} // namespace

std::string attemptPage(LessonScene& scene, Renderer& renderer, const Judgement& judgement, const AttemptFacts& facts,
                        const std::string& driver) {
    const Trainer& trainer = scene.trainer();
    ResultContext context;
    context.version = programVersion();
    context.commit = programCommit();
    context.renderer = driver;
    context.date = facts.head.date;
    context.attempt = facts;
    context.section = trainer.section();
    context.judgement = judgement;
    context.surfaceBytes = scene.surface().bytes();
    const LessonResult result = trainer.result();
    Lesson lesson = trainer.lesson();
    lesson.torchFile.clear(); // the person led the torch, so the page shows no file
    RunResults results = resultsOf(resultEntries(lesson, &result, context), judgement);
    results.pictures = picturesOf(scene, renderer);
    return reportPage(results);
}

fs::path attemptPageName(const fs::path& record, const std::string& lesson, const std::string& date) {
    if (!record.empty()) {
        fs::path page = record;
        return freeName(page.replace_extension(".html"));
    }
    std::string name = lesson + " " + date + ".html";
    std::replace(name.begin(), name.end(), ':', '.');
    return freeName(pagesFolder() / name);
}

fs::path keptAttemptPage(const fs::path& recording) {
    const fs::path page = pagesFolder() / (recording.stem().string() + ".html");
    std::error_code missing;
    if (fs::is_regular_file(page, missing)) return page;
    const auto attempt = readRecordedAttempt(recording);
    if (!attempt) throw InputError(recording, 0, "is no recorded attempt; expected a recording");
    writeFile(page, reportPage(readRecordResults(recording, findLessonOf(*attempt, LessonFolders::ofUser()))));
    return page;
}

namespace {

/// Name of the running attempt's page: next to its record, or by the name of its recording, or by its lesson.
fs::path pageOf(const AttemptLog& log, const std::string& lesson, const std::string& date) {
    const fs::path record = log.records().wholeFile();
    const bool recorded = log.recordings().current() != nullptr;
    if (!record.empty() || !recorded) return attemptPageName(record, lesson, date);
    return freeName(pagesFolder() / (log.recordings().file().stem().string() + ".html"));
}

} // namespace

std::filesystem::path writeAttemptPage(LessonSession& session, double zoom, const std::string& driver) {
    const Attempt& attempt = session.attempt();
    LessonValues& values = session.values();
    if (!session.judges() || !attempt.judged() || session.run().arc().burns())
        throw InputError("there is no judged attempt; expected a judged weld with the arc out");
    const Judgement& judgement = attempt.judged()->judgement;
    AttemptFacts facts;
    facts.head.date = formatDate(std::chrono::system_clock::now());
    facts.head.person = session.log().records().welder().person.name;
    facts.head.personId = session.log().records().welder().person.id;
    facts.forScore = values.forScore();
    facts.realTime = judgement.realTime;
    facts.zoom = zoom;
    facts.guided = session.deskTorch().guided();
    facts.swung = session.deskTorch().weave().swung();
    facts.held = keysOf(attempt.cues().notedHeld(), judgement.distance);
    facts.changed = values.workpieceChanged() || values.settingsChanged();
    if (const CueSet used = attempt.cues().used(); !used.empty()) facts.cues = used.names();
    facts.ghost = attempt.ghost().used();
    const fs::path page = pageOf(session.log(), session.lesson().key, facts.head.date);
    writeFile(page, attemptPage(*session.run().scene(), session.picture().renderer(), judgement, facts, driver));
    session.run().metalChanged();
    session.run().clock().restart(); // the metal does not catch up on the time that the page took
    return page;
}

} // namespace meltpool
