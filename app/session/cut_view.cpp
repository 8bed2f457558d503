#include "app/session/cut_view.hpp"

#include "core/base/words.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr double kMm = 1e-3;
constexpr double kNoticed = 0.05e-3; ///< m, travel after which the cut is made again

/// Place of the verdict's first failure.
std::optional<double> failedPlace(const Judgement& judgement) {
    if (!judgement.verdict) return std::nullopt;
    for (const VerdictItem& item : judgement.verdict->items)
        if (item.state == VerdictState::fail && item.place) return item.place;
    return std::nullopt;
}

std::optional<double> judgedPlace(const AttemptJudge& judge) {
    if (!judge.judged()) return std::nullopt;
    const Judgement& judgement = judge.judged()->judgement;
    if (const auto failed = failedPlace(judgement)) return failed;
    if (!judgement.weld || judgement.weld->stations.empty()) return std::nullopt;
    return judgement.weld->stations[judgement.weld->stations.size() / 2].place;
}

/// Station at a place; null outside the stations.
const WeldStation* stationAt(const WeldMeasures& weld, double place) {
    const WeldStation* nearest = nullptr;
    for (const WeldStation& station : weld.stations)
        if (nearest == nullptr || std::abs(station.place - place) < std::abs(nearest->place - place))
            nearest = &station;
    const bool here = nearest != nullptr && std::abs(nearest->place - place) <= 0.5 * weld.pitch + kNoticed;
    return here ? nearest : nullptr;
}

} // namespace

bool CutView::canCut(const Lesson& lesson) {
    return lesson.model == LessonModel::Weld &&
           static_cast<WorkpieceKind>(lesson.workpiece.kind) != WorkpieceKind::Pipe;
}

void CutView::open(const Trainer& trainer, const AttemptJudge& judge) {
    if (!canCut(trainer.lesson())) return;
    shown_ = true;
    const double half = 0.5 * kMm * static_cast<double>(trainer.lesson().workpiece.lengthMm);
    reach_ = {-half, half};
    section_.reset();
    if (const auto place = judgedPlace(judge)) {
        moveTo(*place);
    } else {
        section_ = trainer.section();
        if (section_) moveTo(section_->cut.at());
        section_.reset(); // its place may differ from the cut's
    }
    update(trainer, judge);
}

void CutView::moveTo(double place) {
    if (std::isfinite(place)) place_ = std::clamp(place, reach_.low, reach_.high);
}

void CutView::update(const Trainer& trainer, const AttemptJudge& judge) {
    if (!shown_) return;
    if (section_ && std::abs(place_ - cutAt_) < kNoticed && cutSteps_ == trainer.steps() &&
        judgements_ == judge.count())
        return;
    section_ = trainer.section(place_);
    cutAt_ = place_;
    cutSteps_ = trainer.steps();
    judgements_ = judge.count();
    measure(trainer, judge);
}

void CutView::measure(const Trainer& trainer, const AttemptJudge& judge) {
    const WorkpieceParameters& workpiece = trainer.lesson().workpiece;
    const WeldKind kind = weldKindOf(workpiece);
    marks_.clear();
    station_.reset();
    judged_ = judge.judged() && judge.judged()->judgement.weld;
    if (!section_) return;
    if (!judged_)
        station_ = stationOf(section_->figures, kind, place_);
    else if (const WeldStation* station = stationAt(*judge.judged()->judgement.weld, place_))
        station_ = *station;
    if (station_)
        marks_ = sectionMarks(*station_, kind, section_->map, section_->cut.fusion, SectionFaces::of(workpiece));
}

double CutView::extent() const {
    constexpr float kLeastSpacings = 8;
    glm::vec2 low(std::numeric_limits<float>::max()), high(-low);
    for (const SectionMark& mark : marks_) {
        if (mark.kind == SectionMark::Kind::note) continue;
        low = glm::min(low, glm::min(mark.from, mark.to));
        high = glm::max(high, glm::max(mark.from, mark.to));
    }
    const float least = section_ ? kLeastSpacings * section_->map.spacing : 0;
    return static_cast<double>(low.x > high.x ? least : std::max(glm::length(high - low), least));
}

SectionView CutView::view() const {
    SectionView view;
    view.shown = shown_;
    view.at = static_cast<float>(cutAt_);
    view.map = section_ ? &section_->map : nullptr;
    return view;
}

std::span<const SectionStroke> CutView::strokes(const MarkLayout& layout) {
    strokes_.clear();
    layOutMarks(marks_, layout, strokes_);
    return strokes_;
}

std::string cutNote(const CutView& cut) {
    const PhraseNumber place(cut.place() / kMm, 1);
    if (cut.station() == nullptr) return phrase("cut.beside", {{"place", place}});
    if (!cut.judged()) return phrase("cut.not_judged", {{"place", place}});
    return phrase("cut.judged", {{"place", place}, {"station", PhraseNumber(cut.station()->place / kMm, 1)}});
}

} // namespace meltpool
