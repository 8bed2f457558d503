// The finished weld cut open: its place along the seam, the section and the measures in it. Window and headset draw one
// and the same cut.
#pragma once

#include "app/activities/attempt_judge.hpp"
#include "core/render/section.hpp"
#include "core/scene/section_marks.hpp"
#include "core/training/judging/section_measures.hpp"
#include "core/training/trainer/trainer.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace meltpool {

class CutView {
  public:
    /// True if this lesson's workpiece can be cut open: a weld lesson's, unless its seam goes around a pipe.
    static bool canCut(const Lesson& lesson);

    /// Cuts at the judged weld's failure; without one in the middle of what is judged or was welded. Waits for the GPU.
    void open(const Trainer& trainer, const AttemptJudge& judge);
    void close() { *this = CutView(); }
    bool shown() const { return shown_; }

    /// Place along the seam, m, and the range it may take: the whole workpiece.
    double place() const { return place_; }
    const FaceStretch& reach() const { return reach_; }
    void moveTo(double place);

    /// Cuts again if place, metal or judgement have changed, and then waits for the GPU.
    void update(const Trainer& trainer, const AttemptJudge& judge);

    /// Station that the verdict judges at this place, or the cut's own while nothing is judged; null outside the judged
    /// range.
    const WeldStation* station() const { return station_ ? &*station_ : nullptr; }
    /// True if station() belongs to the judged weld.
    bool judged() const { return judged_; }
    const std::vector<SectionMark>& marks() const { return marks_; }
    /// Size across all measures, m, at least some particles: the part of the section that a picture should show.
    double extent() const;

    /// Section for the renderer, without measures; borrows from this.
    SectionView view() const;
    /// Measures as strokes, valid until the next call.
    std::span<const SectionStroke> strokes(const MarkLayout& layout);

  private:
    void measure(const Trainer& trainer, const AttemptJudge& judge);

    bool shown_ = false;
    double place_ = 0;
    FaceStretch reach_;
    std::optional<WeldSection> section_;
    std::optional<WeldStation> station_;
    bool judged_ = false;
    std::vector<SectionMark> marks_;
    std::vector<SectionStroke> strokes_;
    double cutAt_ = 0;      ///< place of section_, m
    size_t cutSteps_ = 0;   ///< steps of the metal when it was cut
    size_t judgements_ = 0; ///< count of judgements at that time
};

/// Note above the measures: "Station at 12.0 mm, as the verdict has it." and the like.
std::string cutNote(const CutView& cut);

} // namespace meltpool
