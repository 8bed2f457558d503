// Makers' charts for the open lesson: the rows that fit its plates and machine, in words, and the taking of one.
#pragma once

#include "app/session/parameter_section.hpp"
#include "core/base/units.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/weld/process/machine_chart.hpp"

#include <array>
#include <string>
#include <vector>

namespace meltpool {

/// One row of a chart as the machine's panel shows it.
struct ShownChartRow {
    struct Value {
        std::string label, text;
    };
    StartingValues values;
    std::string title;          ///< the plates that it is for
    std::vector<Value> figures; ///< middle and range of each of its values
    std::string source;
    std::vector<std::string> notes; ///< a sentence each
};

/// Rows for the lesson's plates, process, wire and gas as they are set. It refers to the lesson and to the section of
/// its machine, which must outlive it unmoved.
class ChartValues {
  public:
    ChartValues(const Lesson& lesson, const ParameterSection& machine) : lesson_(lesson), machine_(machine) {}

    /// Finds the rows again if plates, machine or units changed since the last call; else allocates nothing.
    void update();

    /// True for a process that charts can be for: a weld with an arc.
    bool applies() const;
    /// The rows, the best first.
    const std::vector<ShownChartRow>& rows() const { return rows_; }
    /// Sentence without rows, or about a chart's file that cannot be read; else empty.
    const std::string& notice() const { return notice_; }
    /// Row that is shown; no-op without rows.
    const ShownChartRow& shown() const { return rows_[shown_]; }
    size_t shownIndex() const { return shown_; }
    void showNext() { shown_ = rows_.empty() ? 0 : (shown_ + 1) % rows_.size(); }

    /// True if the trainee may set at least one of the shown row's values on the machine now.
    bool canTake() const;
    /// True if a value that the trainee may set is outside the lesson's limits.
    bool beyondLimits() const;
    /// Sets the middle values of the shown row, as far as the lesson leaves them to the trainee and its limits allow.
    void take();

  private:
    /// Everything that decides which rows fit, and their words.
    struct Asked {
        int kind = -1, position = 0, process = 0;
        float thickness = 0;
        double wire = 0, electrode = 0, heldBehind = 0;
        std::string_view electrodeName{};
        const ShieldingGas* gas = nullptr;
        UnitSystem units = UnitSystem::metric;

        bool operator==(const Asked&) const = default;
    };
    /// A setting of the machine and the row's middle value for it.
    struct Setting {
        const Parameter* parameter = nullptr;
        double value = 0;
    };

    Asked asked() const;
    std::array<Setting, 3> settings() const;

    const Lesson& lesson_;
    const ParameterSection& machine_;
    Asked asked_;
    std::string metal_; ///< metal of the rows
    std::vector<ShownChartRow> rows_;
    std::string notice_;
    size_t shown_ = 0;
};

} // namespace meltpool
