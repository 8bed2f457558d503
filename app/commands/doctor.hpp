// A finding of `meltpool doctor`; every part of the program reports in this form.
#pragma once

#include <string>
#include <vector>

namespace meltpool {

struct Finding {
    enum class State {
        good,
        note,   ///< a missing part that some runs do without
        missing ///< a missing part that every run needs
    };
    std::string what;
    State state = State::good;
    std::string found;
    std::string remedy; ///< how to get it; empty if nothing is missing
};

/// Prints a list; returns false if something is missing.
bool printFindings(const std::vector<Finding>& findings);

} // namespace meltpool
