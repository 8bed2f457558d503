// The finished weld cut open: where along the seam, what the cut shows, and the measures in it. Window and headset draw
// the same one.
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
    /// Whether this lesson's workpiece can be cut open: a weld lesson's, unless its seam goes around a pipe.
    static bool canCut(const Lesson& lesson);

    /// Cuts where the judged weld fails, else in the middle of what is judged or was welded. Waits for the GPU.
    void open(const Trainer& trainer, const AttemptJudge& judge);
    void close() { *this = CutView(); }
    bool shown() const { return shown_; }

    /// m along the seam, and from where to where it may go: the whole workpiece.
    double place() const { return place_; }
    const FaceStretch& reach() const { return reach_; }
    void moveTo(double place);

    /// Cuts anew where the place, the metal or the judgement is another one. Waits for the GPU then.
    void update(const Trainer& trainer, const AttemptJudge& judge);

    /// The station that the verdict judges at this place, or of the cut itself while nothing is judged; null beside
    /// what is judged.
    const WeldStation* station() const { return station_ ? &*station_ : nullptr; }
    /// station() is one of the judged weld's.
    bool judged() const { return judged_; }
    const std::vector<SectionMark>& marks() const { return marks_; }
    /// m across all measures, at least some particles: how much of the section a picture should show.
    double extent() const;

    /// What the renderer shows, without measures; borrows from this.
    SectionView view() const;
    /// The measures as strokes, valid until the next call.
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
    double cutAt_ = 0;      ///< of section_, m
    size_t cutSteps_ = 0;   ///< of the metal when it was cut
    size_t judgements_ = 0; ///< that there were then
};

/// What the view says of its measures: "Station at 12.0 mm, as the verdict has it." and the like.
std::string cutNote(const CutView& cut);

} // namespace meltpool
