// A judgement in a welder's words: the content of the result panel of window and headset, without drawing it.
#pragma once

#include "core/training/judging/judgement.hpp"

#include <string>
#include <vector>

namespace meltpool {

/// Outcome of a row. Its words say so too; the state only chooses a colour.
enum class RowState {
    plain, ///< no target
    good,
    bad,
    open ///< neither: not resolved, or estimated
};

struct JudgementRow {
    std::string name;
    std::string value;  ///< short text next to the name
    std::string detail; ///< a line below; may be empty
    RowState state = RowState::plain;
};

struct JudgementSection {
    const char* name = ""; ///< one name for every language
    std::string title;
    std::string note; ///< a sentence below the title; may be empty
    std::vector<JudgementRow> rows;
};

/// A likely cause with its remedy.
struct CureRow {
    std::string sentence;
    std::string whatIf; ///< wish that tries it; empty: none, or a row above has it
    std::string change; ///< that wish in words
};

struct JudgementRows {
    bool scored = false;     ///< `score` has points
    std::string score;       ///< "Score 84 of 100", or a text that there is none
    std::string scoreNote;   ///< reason for a missing score, or the welded share of the seam
    std::string verdict;     ///< "Accepted", "Not accepted", or a text that there is none; the standard is in `judged`
    std::string verdictNote; ///< failures, or how much was judged; empty without a verdict
    RowState verdictState = RowState::plain;
    std::vector<std::string> corrections;           ///< sentences, costliest first
    std::vector<CureRow> cures;                     ///< one for each imperfection that fails
    JudgementSection technique{"hand", {}, {}, {}}; ///< one row per parameter, in the lesson's order
    JudgementSection judged{
        "standard", {}, {}, {}}; ///< one row per imperfection: failed, not resolved, estimated, passed
    JudgementSection measured{"measured", {}, {}, {}}; ///< figures of the weld, means along the seam
};

/// Rows of a judgement. `bands`: of the lesson, for the targets; null if it has none. `held`: quantities that the desk
/// held; their points say nothing about the person's hand.
JudgementRows judgementRows(const Judgement& judgement, const TechniqueBands* bands, const QuantitySet& held = {});

} // namespace meltpool
