// A question that the person must answer before the lesson goes on, in the window or on the headset's panel.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

struct Question {
    std::string text;                 ///< empty: nothing is asked
    std::vector<std::string> answers; ///< empty: the person is told to wait
    int answered = -1;                ///< number of the chosen answer; below 0 while there is none

    bool asked() const { return !text.empty(); }
};

} // namespace meltpool
