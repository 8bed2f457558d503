// The best score of each lesson, and the fading of its cues, stored in the user's folder between starts of the program.
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

class TomlTable;

/// Simulated over real time below which no attempt for score starts, and which a best score reports.
inline constexpr double kLeastSpeedForScore = 0.95;

/// Result of a person's attempt at a lesson.
struct BestScore {
    double score = 0;      ///< 0..100
    bool accepted = false; ///< the weld, by the lesson's standard; false if it names none
    // Help during the attempt.
    double zoom = 1;         ///< scale at which the workpiece was shown
    bool forScore = false;   ///< the machine was measured to keep the metal at the clock's time
    bool changed = false;    ///< workpiece, particles or given settings differed from the lesson's
    bool guided = false;     ///< the desk's torch travelled along the seam by itself
    bool swung = false;      ///< the desk's torch swung across the seam by itself
    double realTime = 1;     ///< simulated over real time: a slow metal gives the hand more time
    CueSet cues = {};        ///< cues that were on while the arc burned
    std::string ghost = {};  ///< ghost that was on while the arc burned, see ghostName(); empty: none
    std::string chosen = {}; ///< settings of the machine that the person chose, see Lesson::chosenText()
};

/// Score of an attempt as far as it can be a best one; nothing if it has no score. The caller fills in the help.
std::optional<BestScore> countedScore(const Judgement& judgement);

/// Text of a best score: "Best 84, accepted, zoom 4, voltage 22 V".
std::string bestScoreText(const BestScore& best);

/// Best scores in a file, those of tests apart from practice. Other programs may use the file too, on other machines: a
/// write merges with its current contents, the better score of each lesson, and new attempts at a cue are added to its
/// counts.
class BestScores {
  public:
    /// Reads `file`, a TOML table for each lesson; a missing one is no fault. Never throws for its contents: a faulty
    /// file is moved aside as keepAside() does, and reported in faults(). If that fails no file takes its place.
    explicit BestScores(std::filesystem::path file);

    /// Holds scores and skill in memory only, for a guest.
    BestScores() : writable_(false) {}

    /// One sentence for each fault in the file, with its line, and the place where the file was moved. Faults that
    /// another program has brought in since are added when the file is written.
    const std::vector<std::string>& faults() const { return faults_; }

    /// Best score of a lesson in practice, and in tests; null if no attempt of that kind counts yet.
    const BestScore* find(std::string_view lesson) const;
    const BestScore* findTest(std::string_view lesson) const;

    /// Takes a score that is better than the lesson's best of its kind so far, and writes the file. Returns true if it
    /// is better. Throws whatever FileTurn and writeFile() throw; the score is then held until the program ends.
    bool offer(const std::string& lesson, const BestScore& score);

    /// Skill of the trainee at the lesson, from which its cues fade.
    CueSkill skill(std::string_view lesson) const;
    /// Skill at the start of an attempt: its own count begins here.
    CueSkill beginAttempt(const std::string& lesson);
    /// Stores the skill at a lesson that has a best score, after the attempt's last judgement, and writes the file if
    /// it changed. Throws as offer().
    void practise(const std::string& lesson, const CueSkill& skill);

  private:
    using Skills = std::map<std::string, CueSkill, std::less<>>;
    using Scores = std::map<std::string, BestScore, std::less<>>;

    /// Content of the file.
    struct Content {
        Scores best;   ///< in practice
        Scores tests;  ///< in attempts for score
        Skills skills; ///< skills of the lessons in both
    };

    Content load(bool again);
    Content read();
    static void readLesson(TomlTable& table, const std::string& lesson, Content& content);
    void save();

    std::filesystem::path file_;
    bool writable_ = true; ///< true: there is a file, and no faulty one is at its place
    std::vector<std::string> faults_;
    Content content_;
    Skills written_;   ///< skills in the file when content_ was last merged with it
    Skills attempted_; ///< skills of the current attempt: at its start, or at its last judgement
};

} // namespace meltpool
