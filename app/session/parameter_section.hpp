// Parameters that belong together: a menu's group, a table of the settings file.
#pragma once

#include "core/base/parameter.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meltpool {

/// Values of parameters before any change, as text by key, so that a control can restore them.
using DefaultTexts = std::map<std::string, std::string, std::less<>>;

struct ParameterSection {
    /// Takes the parameters' current values as the defaults.
    ParameterSection(std::string theName, ParameterList list);

    std::string name; ///< prefix of its controls' names, and its table in the settings file
    /// Table of its labels and tooltips in a language's file; `name` by default.
    std::string words;
    ParameterList parameters;
    DefaultTexts defaults;
    /// Keys that menus leave out, because they have no effect in this lesson. Files and `--set` take them.
    std::span<const std::string_view> idle;

    /// Keys that a trainee sets; the others are in the expert drawer. Empty: a trainee sets all of them.
    std::span<const std::string_view> everyday;

    /// Keys that the trainee chooses; the lesson gives all others while `fixed` holds (null: never).
    std::vector<std::string> chosen;
    const bool* fixed = nullptr;

    /// True if the trainee cannot change the parameter now: menus show it without a control.
    bool isGiven(const Parameter& parameter) const;
    /// True if the parameter belongs in the expert drawer.
    bool isExpert(const Parameter& parameter) const;
    /// True if menus show the parameter.
    bool shows(const Parameter& parameter) const;
};

} // namespace meltpool
