// The bend test of AWS D1.1 on a measured weld: straps cut across it, bent, and looked at where fusion lacks. Of a
// fillet the break test in its place.
#pragma once

#include "core/training/judging/verdict.hpp"

#include <optional>
#include <vector>

namespace meltpool {

/// Which face of a strap is stretched. Of a fillet the joint is folded onto its face until it breaks, or lies flat.
enum class BendKind { face, root, side, filletBreak };

/// AWS D1.1, visual examination of bend specimens (table 6.1 to 2015, 8.1 from 2020). Lengths in m.
struct BendRule {
    double counted = 1e-3;   ///< shorter openings do not count
    double single = 3e-3;    ///< longest allowed
    double together = 10e-3; ///< of all counted ones of a strap
    /// Longest allowed at a corner of the strap where it comes from lack of fusion. Other corner cracks may be 6 mm;
    /// this metal has none.
    double corner = 3e-3;
    double strapWidth = 38e-3;    ///< along the seam, of face and root bends
    double sideThickness = 10e-3; ///< plates above it are bent sideways; also the width of such a strap along the seam
    double diameter = 4;          ///< of the former that the strap is bent around, in thicknesses of the strap
};

/// A place of the stretched face that gapes. `from` and `to` are m along the seam; of a side bend, whose stretched face
/// is a section, m up from the lower face.
struct BendOpening {
    double from = 0, to = 0;
    double depth = 0;      ///< m, of what is not fused under the stretched face; of a side bend 0: it is not known
    bool resolved = true;  ///< false: as deep as the particles resolve or less, so that it may be fused or not
    bool atCorner = false; ///< reaches an edge of the strap

    double length() const { return to - from; }
};

/// One strap, bent.
struct BentStrap {
    BendKind kind = BendKind::root;
    double from = 0, to = 0; ///< m along the seam
    std::vector<BendOpening> openings;
    double longest = 0;  ///< m, of the resolved openings
    double together = 0; ///< m, of the resolved openings that count
    VerdictState state = VerdictState::notResolved;

    double length() const { return to - from; }
};

/// All straps of a weld.
struct BendTest {
    double plate = 0;     ///< m, thickness of the plate
    double thickness = 0; ///< m, of the straps
    double former = 0;    ///< m, diameter that they are bent around; 0 of a fillet break
    std::vector<BentStrap> straps;
    /// Fails where a strap does, passes where all do.
    VerdictState state = VerdictState::notResolved;
};

/// Bends the weld. Nothing for a bead on a plate, which no such test is made of, and without stations or thickness.
///
/// The judged seam is cut into straps of equal width along it, as many as are at least as wide as the rule says, and at
/// least one. In this metal one and the same strap can be bent over its root and over its face. Plates above
/// `sideThickness` are bent sideways: the stretched face of a strap is then the worst section of its stations. A fillet
/// is broken as one strap.
///
/// A station opens where the gauge finds it unfused (WeldStation::lackOfFusion, rootMissing, hole) by more than half a
/// spacing, is closed where the fusion goes at least as far beyond, and is not resolved between. The root is stretched
/// along the lower face of a butt, the face along its upper one, flush as D1.1 asks for: it opens where an edge is
/// unfused up to there. Openings of neighbouring stations are one, each station a pitch long.
///
/// A strap fails by the openings that are resolved; it is not resolved where the others would make it fail too, and
/// passes otherwise. A fillet passes where its root is fused all along.
std::optional<BendTest> bendTest(const WeldMeasures& weld, double thickness, const BendRule& rule = {});

} // namespace meltpool
