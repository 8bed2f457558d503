// A question that the person must answer before the lesson goes on, in the window or on the headset's panel.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

struct Question {
    std::string text;                 ///< empty: there is no question
    std::vector<std::string> answers; ///< empty: the person has to wait
    int answered = -1;                ///< number of the chosen answer; negative while there is none

    bool asked() const { return !text.empty(); }
};

} // namespace meltpool
