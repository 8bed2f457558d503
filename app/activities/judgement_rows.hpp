// A judgement in a welder's words: what the result panel of window and headset shows, without drawing it.
#pragma once

#include "core/training/judging/judgement.hpp"

#include <string>
#include <vector>

namespace meltpool {

/// How a row turned out. Its words say so too; the state only chooses a colour.
enum class RowState {
    plain, ///< nothing is asked
    good,
    bad,
    open ///< neither: not resolved, or estimated
};

struct JudgementRow {
    std::string name;
    std::string value;  ///< short, beside the name
    std::string detail; ///< a line below; may be empty
    RowState state = RowState::plain;
};

struct JudgementSection {
    const char* name = ""; ///< in every language
    std::string title;
    std::string note; ///< a sentence below the title; may be empty
    std::vector<JudgementRow> rows;
};

struct JudgementRows {
    std::string score;     ///< "Score 84 of 100", or that there is none
    std::string scoreNote; ///< why there is none, or how much of the seam was welded
    std::string verdict;   ///< "Accepted", "Not accepted", or that there is none; by which standard stands in `judged`
    std::string verdictNote; ///< what fails; empty where nothing does
    RowState verdictState = RowState::plain;
    std::vector<std::string> corrections;           ///< sentences, dearest first
    JudgementSection technique{"hand", {}, {}, {}}; ///< one row a parameter, in the lesson's order
    JudgementSection judged{
        "standard", {}, {}, {}}; ///< one row an imperfection: failed, not resolved, estimated, passed
    JudgementSection measured{"measured", {}, {}, {}}; ///< the weld's figures, means along the seam
};

/// `bands`: of the lesson, for what was asked; null where it has none.
JudgementRows judgementRows(const Judgement& judgement, const TechniqueBands* bands);

} // namespace meltpool
