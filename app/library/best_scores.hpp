// The best score of each lesson, and how far its cues have faded, kept in the user's folder from one start of the
// program to the next.
#pragma once

#include "core/training/feedback/cues.hpp"
#include "core/training/judging/judgement.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Simulated over real time below which no attempt for score starts, and which a best score tells.
inline constexpr double kLeastSpeedForScore = 0.95;

/// How a person's attempt at a lesson turned out.
struct BestScore {
    double score = 0;      ///< 0..100
    bool accepted = false; ///< the weld, by the lesson's standard; false where it names none
    // Help that the attempt had.
    double zoom = 1;         ///< size at which the workpiece was shown
    bool forScore = false;   ///< the machine was measured to keep the metal at the clock's time
    bool changed = false;    ///< workpiece, particles or given settings were others than the lesson's
    bool guided = false;     ///< the torch of the desk went along the seam by itself
    double realTime = 1;     ///< simulated over real time: on a slow metal the hand has more time
    CueSet cues = {};        ///< that were on while the arc burned
    std::string ghost = {};  ///< whose was on while the arc burned, see ghostName(); empty: none
    std::string chosen = {}; ///< the machine's settings that the person chose, see Lesson::chosenText()
};

/// The attempt as far as it can be a best one; nothing where it is not scored. Help is left to the caller.
std::optional<BestScore> countedScore(const Judgement& judgement);

/// "Best 84, accepted, zoom 4, voltage 22 V".
std::string bestScoreText(const BestScore& best);

/// Other programs may have the same file, on other machines too: whatever is written is put together with what the file
/// holds by then, the better score of each lesson, and attempts at a cue counted on from there.
class BestScores {
  public:
    /// Reads `file`, a TOML table for each lesson; a missing one is no fault. Never throws for its contents: a faulty
    /// file is kept aside as keepAside() does, and faults() tells so. Where that fails no file takes its place.
    explicit BestScores(std::filesystem::path file);

    /// One sentence for each fault in the file, with its line, and where the file is kept. Those that another program
    /// has brought in since are added when the file is written.
    const std::vector<std::string>& faults() const { return faults_; }

    /// Null where no attempt at the lesson counts yet.
    const BestScore* find(std::string_view lesson) const;

    /// Takes a score that is better than the lesson's best so far, and writes the file. True where it is better. Throws
    /// what FileTurn and writeFile() throw; the score is then kept until the program ends.
    bool offer(const std::string& lesson, const BestScore& score);

    /// How far the trainee has come with the lesson, from which its cues fade.
    CueSkill skill(std::string_view lesson) const;
    /// The same for an attempt that begins: what it adds is counted from here.
    CueSkill beginAttempt(const std::string& lesson);
    /// Keeps that of a lesson that has a best score, after the attempt as it was judged last, and writes the file where
    /// it is another than before. Throws as offer().
    void practise(const std::string& lesson, const CueSkill& skill);

  private:
    using Skills = std::map<std::string, CueSkill, std::less<>>;

    /// What the file holds.
    struct Content {
        std::map<std::string, BestScore, std::less<>> best;
        Skills skills; ///< of lessons in `best`
    };

    Content load(bool again);
    Content read();
    void save();

    std::filesystem::path file_;
    bool writable_ = true; ///< no faulty file stands at its place
    std::vector<std::string> faults_;
    Content content_;
    Skills written_;   ///< as they were in the file when content_ was last put together with it
    Skills attempted_; ///< of the attempt under way: as it began, or was judged last
};

} // namespace meltpool
