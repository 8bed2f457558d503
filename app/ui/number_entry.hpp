// Text field that takes the place of a slider while a person types its number.
#pragma once

#include "app/ui/widgets.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace meltpool::ui {

/// Reads a number as people write it: with a point or a comma as its decimal mark, and `unit` behind it if they like.
/// Empty if the text is not one finite number.
std::optional<double> typedNumber(std::string_view text, std::string_view unit = {});

/// Numbers that a control takes.
struct NumberRange {
    double low = 0;
    double high = 0;
    bool whole = false;
    std::string_view unit; ///< "V"; empty: none

    bool takes(double value) const;
};

/// One text field at a time, over the slider of that name.
class NumberEntry {
  public:
    void open(std::string_view name, double value);
    /// True over this slider; a field that was out of sight for a frame is closed.
    bool isOpen(std::string_view name) const;

    /// Draws the field. Returns the number once it is entered (Enter, or a press elsewhere). Text that the range does
    /// not take changes nothing: after Enter it stays to be corrected; Escape closes the field and changes nothing.
    std::optional<double> draw(const NumberRange& range);

    /// Draws below the control of this name why its last text was not taken; `allowed` is a sentence about the range.
    void drawRefusal(Context& context, std::string_view name, std::string_view allowed) const;
    bool refused(std::string_view name) const { return refusedAt_ == name; }
    /// Removes the refusal, as when the slider moves.
    void forget() { refusedAt_.clear(); }

  private:
    std::string name_; ///< control with the field; empty: none
    char text_[64] = {};
    char first_[64] = {}; ///< text when the field was opened
    bool fresh_ = false;  ///< the field takes the keys with its next frame
    int frame_ = 0;       ///< Dear ImGui's last frame with the field
    std::string refusedAt_;
    std::string refusedText_;
};

} // namespace meltpool::ui
