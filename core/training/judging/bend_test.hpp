// Bends a measured weld as AWS D1.1 does: straps cut across it are bent and searched for lack of fusion. A fillet gets
// the break test instead.
#pragma once

#include "core/training/judging/verdict.hpp"

#include <optional>
#include <vector>

namespace meltpool {

/// Face of a strap that is stretched. The joint of a fillet is folded onto its face until it breaks or is flat.
enum class BendKind { face, root, side, filletBreak };

/// AWS D1.1, visual examination of bend specimens (table 6.1 to 2015, 8.1 from 2020). Lengths in m.
struct BendRule {
    double counted = 1e-3;   ///< shorter openings do not count
    double single = 3e-3;    ///< longest allowed opening
    double together = 10e-3; ///< total of all counted openings of a strap
    /// Longest allowed opening at a corner of the strap, from lack of fusion. Other corner cracks may be 6 mm; this
    /// metal has none.
    double corner = 3e-3;
    double strapWidth = 38e-3;    ///< width of face and root bends along the seam
    double sideThickness = 10e-3; ///< thicker plates are bent sideways; also the width of such a strap along the seam
    double diameter = 4;          ///< diameter of the former, in thicknesses of the strap
};

/// A place of the stretched face that gapes. `from` and `to` are m along the seam; for a side bend, whose stretched
/// face is a section, m up from the lower face.
struct BendOpening {
    double from = 0, to = 0;
    double depth = 0;      ///< m without fusion under the stretched face; 0 for a side bend: unknown
    bool resolved = true;  ///< false: at most as deep as the particles resolve, so that it may be fused or not
    bool atCorner = false; ///< reaches an edge of the strap

    double length() const { return to - from; }
};

/// One strap, bent.
struct BentStrap {
    BendKind kind = BendKind::root;
    double from = 0, to = 0; ///< m along the seam
    std::vector<BendOpening> openings;
    double longest = 0;  ///< m, longest resolved opening
    double together = 0; ///< m, total of the resolved openings that count
    VerdictState state = VerdictState::notResolved;

    double length() const { return to - from; }
};

/// Results of all straps of a weld.
struct BendTest {
    double plate = 0;     ///< m, thickness of the plate
    double thickness = 0; ///< m, thickness of the straps
    double former = 0;    ///< m, diameter of the former; 0 for a fillet break
    std::vector<BentStrap> straps;
    /// Fails if a strap fails, passes if all pass.
    VerdictState state = VerdictState::notResolved;
};

/// Bends the weld. Empty for a bead on a plate, which has no such test, and without stations or thickness.
///
/// The judged seam is cut into straps of equal width along it, as many as are at least as wide as the rule says, and at
/// least one. In this metal a strap can be bent over its root and over its face. Plates above `sideThickness` are bent
/// sideways: the stretched face of a strap is then the worst section of its stations. A fillet is broken as one strap.
///
/// A station opens if the gauge finds it unfused (WeldStation::lackOfFusion, rootMissing, hole) by more than half a
/// spacing, is closed if the fusion goes at least as far beyond, and is not resolved between. The root is stretched
/// along the lower face of a butt, the face along its upper one, flush as D1.1 asks for: it opens if an edge is unfused
/// up to there. Openings of neighbouring stations are one, each station a pitch long.
///
/// A strap fails by its resolved openings; it is not resolved if only the others would make it fail, and passes
/// otherwise. A fillet passes if its root is fused all along.
std::optional<BendTest> bendTest(const WeldMeasures& weld, double thickness, const BendRule& rule = {});

} // namespace meltpool
