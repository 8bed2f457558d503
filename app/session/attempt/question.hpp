// A question that the person must answer before the lesson goes on, in the window or on the headset's panel.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

struct Question {
    std::string text;
    std::vector<std::string> answers;
    int answered = -1; ///< number of the chosen answer; below 0 while there is none

    bool asked() const { return !answers.empty(); }
};

} // namespace meltpool
