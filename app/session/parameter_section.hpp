// Parameters that belong together: a menu's group, a table of the settings file.
#pragma once

#include "core/base/parameter.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// A parameter's values before anyone touched them, as text by key, so that a control can restore them.
using DefaultTexts = std::map<std::string, std::string, std::less<>>;

struct ParameterSection {
    /// The defaults are the values that the parameters hold now.
    ParameterSection(std::string theName, ParameterList list);

    std::string name; ///< begins the names of its controls, and is its table in the settings file
    /// The table of its labels and tooltips in a language's file; the name where nothing else is set.
    std::string words;
    ParameterList parameters;
    DefaultTexts defaults;
    /// Keys that menus leave out, since they do nothing in the lesson at hand. Files and `--set` take them.
    std::span<const std::string_view> idle;

    /// Keys that a trainee sets; the others stand in the expert drawer. Empty: a trainee sets all of them.
    std::span<const std::string_view> everyday;

    /// Keys that the trainee chooses; all others are given by the lesson while `fixed` (null: never) holds.
    std::vector<std::string> chosen;
    const bool* fixed = nullptr;

    /// The trainee cannot change the parameter now: menus show it without a control.
    bool isGiven(const Parameter& parameter) const;
    /// The parameter belongs into the expert drawer.
    bool isExpert(const Parameter& parameter) const;
    /// Menus show the parameter.
    bool shows(const Parameter& parameter) const;
};

} // namespace meltpool
