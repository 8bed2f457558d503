// Shapes as the text of an SVG drawing.
#pragma once

#include <string>
#include <string_view>

namespace meltpool {

/// Text as HTML and SVG show it: &, <, > and quotes escaped, control characters left out.
std::string escaped(std::string_view text);

/// Number rounded to so many decimals, "-" only before a non-zero result.
std::string rounded(double value, int decimals);

/// Drawing of width x height units that grows by its shapes. Styles are classes of the page's style sheet.
class SvgText {
  public:
    SvgText(double width, double height, std::string_view description);

    void rectangle(double left, double top, double right, double bottom, std::string_view style);
    void line(double x1, double y1, double x2, double y2, std::string_view style);
    /// Adds a word. `anchor`: start, middle or end. `style` may be empty.
    void word(double x, double y, std::string_view anchor, std::string_view word, std::string_view style = {});
    /// Adds an open line through "x,y x,y ..".
    void polyline(std::string_view points, std::string_view style);
    /// Adds a dot with a tooltip.
    void dot(double x, double y, std::string_view style, std::string_view tooltip);
    /// Adds any outline, in the commands of an SVG path.
    void path(std::string_view commands, std::string_view style);

    /// Complete element.
    std::string element() const { return text_ + "</svg>\n"; }

    /// Coordinate as shapes write it: one decimal.
    static std::string coordinate(double value) { return rounded(value, 1); }
    /// Point as "x,y".
    static std::string point(double x, double y) { return coordinate(x) + "," + coordinate(y); }

  private:
    std::string text_;
};

} // namespace meltpool
