// Units that people read: millimetres or inches. Files, command line and results stay metric.
#pragma once

#include "core/base/short_text.hpp"

#include <string_view>

namespace meltpool {

enum class UnitSystem { metric, inches };

/// Sets the units of all sentences and figures made from now on. Safe on any thread.
void chooseUnits(UnitSystem system);
UnitSystem chosenUnits();

/// How a quantity of a metric unit is shown.
struct ShownUnit {
    std::string_view name; ///< "in/min"
    double perMetric = 1;  ///< shown = metric * perMetric
    int digits = 0;        ///< digits behind the mark in addition to those of the metric number; may be negative
    int mostDigits = 9;    ///< most digits behind the mark
    bool converts() const { return perMetric != 1; }
};

/// The inch unit for a metric one: mm, mm2 or mm², mm/s, m/min, kJ/mm. Any other unit is itself.
ShownUnit inchUnit(std::string_view metric);

/// The chosen system's unit for a metric one: mm, mm2 or mm², mm/s, m/min, kJ/mm. Any other unit, such as V, is itself.
ShownUnit shownUnit(std::string_view metric);

/// Every number of a text such as "3.5" or "2 to 4", with the decimal mark of its sentence, in the unit that
/// shownUnit() gives for `metric`. Allocates nothing.
ShortText inShownUnit(std::string_view numbers, std::string_view metric);

} // namespace meltpool
