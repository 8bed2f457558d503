// A bent strap, or a broken fillet, as a drawing to scale: the strap from the side, and its stretched face from outside
// with every opening at its place.
#pragma once

#include "core/training/judging/bend_test.hpp"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace meltpool {

/// Kinds of parts in the drawing.
enum class BendPart {
    steel,
    weld,
    opening,   ///< an opening that gapes
    unresolved ///< an opening that may gape or not: an outline
};

/// Convex polygon, mm; x to the right, y downwards.
struct BendShape {
    BendPart part = BendPart::steel;
    std::vector<glm::vec2> points;
};

struct BendLabel {
    glm::vec2 place{0}; ///< mm, middle of the text's upper edge
    std::string text;
};

struct BendDrawing {
    glm::vec2 size{0}; ///< mm, of the sheet under everything
    std::vector<BendShape> shapes;
    std::vector<BendLabel> labels;
};

/// Draws a strap of `test`. Along the seam, across it and in depth everything is to scale; the width of an opening is
/// not known and drawn as a fifth of its length.
BendDrawing drawBend(const BentStrap& strap, const BendTest& test);

/// Sentence about the strap: "Root bend, 0 to 40 mm: passes. Longest opening 2 mm, 4 mm together."
std::string bendSentence(const BentStrap& strap);

} // namespace meltpool
