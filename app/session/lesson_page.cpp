// The part of LessonSession that writes the page of the judged attempt.
#include "app/session/attempt_page.hpp"
#include "app/session/lesson_session.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text.hpp"

#include <chrono>

namespace meltpool {

std::filesystem::path LessonSession::writePage(double zoom, const std::string& driver) {
    if (!judges() || !judge_.judged() || arc().burns())
        throw InputError("there is no judged attempt; expected a weld that was judged, with the arc out");
    const Judgement& judgement = judge_.judged()->judgement;
    AttemptFacts facts;
    facts.head.date = formatDate(std::chrono::system_clock::now());
    facts.forScore = sections_->attempt.forScore;
    facts.realTime = judgement.realTime;
    facts.zoom = zoom;
    facts.guided = desk_.guided();
    facts.changed = workpieceChanged() || settingsChanged();
    if (const CueSet used = cues_.used(); !used.empty()) facts.cues = used.names();
    facts.ghost = ghost_.used();
    std::filesystem::path record;
    if (!records_.lost() && !records_.file().empty() && isPlainFile(records_.file())) record = records_.file();
    const std::filesystem::path page = attemptPageName(record, lesson_.key, facts.head.date);
    writeFile(page, attemptPage(*trainer_, renderer_, judgement, facts, driver));
    surfaceIsOld_ = true;
    clock_.restart(); // the metal does not make good the time that this took
    return page;
}

} // namespace meltpool
