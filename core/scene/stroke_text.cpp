#include "core/scene/stroke_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace meltpool {

namespace {

constexpr float kBaseline = 2, kFigureHeight = 6; ///< heights in the glyphs' grid
constexpr float kGap = 1.6f;                      ///< gap between letters
constexpr float kNarrow = 0.85f;                  ///< width of the grid's columns, in heights of its rows
constexpr float kSpace = 2.4f;
constexpr float kWidth = 0.8f; ///< width of a stroke

/// A letter as lines through places "xy" of a grid; a space begins the next line. Baseline at y = 2, small letters
/// reach y = 6, figures y = 8.
struct Glyph {
    char letter;
    std::string_view lines;
};

/// Letters of the table for signs of two bytes.
constexpr char kDegree = '\x01', kAUmlaut = '\x02', kOUmlaut = '\x03', kUUmlaut = '\x04', kSharpS = '\x05';

struct TwoBytes {
    std::string_view bytes; ///< UTF-8
    char letter;
};
constexpr std::array kTwoBytes{
    TwoBytes{"\xC2\xB0", kDegree},  TwoBytes{"\xC3\xA4", kAUmlaut}, TwoBytes{"\xC3\x84", kAUmlaut},
    TwoBytes{"\xC3\xB6", kOUmlaut}, TwoBytes{"\xC3\x96", kOUmlaut}, TwoBytes{"\xC3\xBC", kUUmlaut},
    TwoBytes{"\xC3\x9C", kUUmlaut}, TwoBytes{"\xC3\x9F", kSharpS},
};

constexpr std::array kGlyphs{
    Glyph{'0', "123243473818070312"},
    Glyph{'1', "172822 1232"},
    Glyph{'2', "07183847460242"},
    Glyph{'3', "07183847463515354443321203"},
    Glyph{'4', "32380444"},
    Glyph{'5', "480805354443321203"},
    Glyph{'6', "473818070312324344351504"},
    Glyph{'7', "084812"},
    Glyph{'8', "15354647381807061504031232434435"},
    Glyph{'9', "031232434738180706153546"},
    Glyph{'.', "1213"}, // taller than a point, so that it is not overlooked
    Glyph{',', "1301"},
    Glyph{'-', "0545"},
    Glyph{'/', "0248"},
    Glyph{'<', "360432"},
    Glyph{kDegree, "1728372617"},
    Glyph{'a', "16364542 441403123243"},
    Glyph{'b', "0802 0516364543321203"},
    Glyph{'c', "4536160503123243"},
    Glyph{'d', "4842 4536160503123243"},
    Glyph{'e', "04444536160503123243"},
    Glyph{'f', "38281712 0626"},
    Glyph{'g', "4641301001 4536160503123243"},
    Glyph{'h', "0802 0516364542"},
    Glyph{'i', "0206 0808"},
    Glyph{'j', "161100 1818"},
    Glyph{'k', "0802 0446 2442"},
    Glyph{'l', "080312"},
    Glyph{'m', "0206 05162522 25364542"},
    Glyph{'n', "0206 0516364542"},
    Glyph{'o', "123243453616050312"},
    Glyph{'p', "0006 0516364543321203"},
    Glyph{'q', "4046 4536160503123243"},
    Glyph{'r', "0206 051636"},
    Glyph{'s', "45361605143443321203"},
    Glyph{'t', "18132232 0636"},
    Glyph{'u', "0603123243 4642"},
    Glyph{'v', "062246"},
    Glyph{'w', "0612253246"},
    Glyph{'x', "0642 0246"},
    Glyph{'y', "0622 461100"},
    Glyph{'z', "06460242"},
    Glyph{kAUmlaut, "16364542 441403123243 1818 3838"},
    Glyph{kOUmlaut, "123243453616050312 1818 3838"},
    Glyph{kUUmlaut, "0603123243 4642 1818 3838"},
    Glyph{kSharpS, "0207183847362544433212"},
};

const Glyph* findGlyph(char letter) {
    const auto found =
        std::find_if(kGlyphs.begin(), kGlyphs.end(), [letter](const Glyph& glyph) { return glyph.letter == letter; });
    return found == kGlyphs.end() ? nullptr : &*found;
}

glm::vec2 placeIn(std::string_view lines, size_t i) {
    return {static_cast<float>(lines[i] - '0'), static_cast<float>(lines[i + 1] - '0')};
}

float widthOf(const Glyph& glyph) {
    float width = 0;
    for (size_t i = 0; i + 1 < glyph.lines.size(); ++i) {
        if (glyph.lines[i] == ' ') continue;
        width = std::max(width, placeIn(glyph.lines, i).x);
        ++i;
    }
    return width;
}

/// Takes the next letter off the text.
char takeLetter(std::string_view& text) {
    for (const TwoBytes& each : kTwoBytes)
        if (text.starts_with(each.bytes)) {
            text.remove_prefix(each.bytes.size());
            return each.letter;
        }
    const char first = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    text.remove_prefix(1);
    return first;
}

float advanceOf(char letter) {
    const Glyph* glyph = findGlyph(letter);
    return glyph == nullptr ? kSpace : widthOf(*glyph) + kGap;
}

} // namespace

float strokeTextLength(std::string_view text, float height) {
    float length = 0;
    while (!text.empty())
        length += advanceOf(takeLetter(text));
    return std::max(length - kGap, 0.0f) * kNarrow * height / kFigureHeight;
}

void appendStrokeText(std::vector<SectionStroke>& strokes, std::string_view text, glm::vec2 origin,
                      const StrokeTextStyle& style) {
    const float unit = style.height / kFigureHeight;
    const auto inPlane = [&](glm::vec2 place, float begin) {
        return origin + unit * (kNarrow * (begin + place.x) * style.right + (place.y - kBaseline) * style.up);
    };
    float begin = 0;
    while (!text.empty()) {
        const char letter = takeLetter(text);
        if (const Glyph* glyph = findGlyph(letter))
            for (size_t i = 0; i + 3 < glyph->lines.size();) {
                const bool last = glyph->lines[i + 2] == ' ';
                if (!last)
                    strokes.push_back({inPlane(placeIn(glyph->lines, i), begin),
                                       inPlane(placeIn(glyph->lines, i + 2), begin), style.colour, kWidth * unit, 0,
                                       glm::vec2(0)});
                i += last ? 3 : 2;
            }
        begin += advanceOf(letter);
    }
}

} // namespace meltpool
