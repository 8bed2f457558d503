// A finding of `meltpool doctor`; every part of the program reports in this form.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

struct Finding {
    enum class State {
        good,
        note,   ///< something is not there that not every run needs
        missing ///< no run works without
    };
    std::string what;
    State state = State::good;
    std::string found;
    std::string remedy; ///< how to get it; empty where nothing is missing
};

/// Prints a list; false when something is missing.
bool printFindings(const std::vector<Finding>& findings);

} // namespace meltpool
