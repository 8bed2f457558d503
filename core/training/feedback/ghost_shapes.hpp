// Draws the ghost: its torch with a name, and next to the pool the differences of the hand, in words that face the eye.
#pragma once

#include "core/render/solids.hpp"
#include "core/training/feedback/cue_shapes.hpp"
#include "core/training/feedback/ghost.hpp"
#include "core/training/feedback/marker_text.hpp"
#include "core/weld/process/processes.hpp"

#include <span>
#include <vector>

namespace meltpool {

/// Parts of a ghost to draw.
struct GhostLook {
    double strength = 1;        ///< 0 gone .. 1
    float size = 1;             ///< scale of its torch relative to the workpiece
    CuePose hand;               ///< pose of one's own torch: the words are next to it, away from the cues' board
    std::string_view name = {}; ///< whose torch it is; empty: no name is drawn
    float boardSide = 0;        ///< side of the pool on which the cues' board is: 1 right, -1 left, 0 none
};

/// Draws a ghost. The words are on the side that the torch came from, nearer to the eye than the pool; beyond the
/// picture's edge, or where the cues' board is, they move above that board. The name is on that side of the ghost's
/// torch, above board and words. Both leave the pool's disc free, as cues do.
class GhostShapes {
  public:
    GhostShapes();

    /// Builds the markers in the world, from the workpiece's frame by `toWorld`; valid until the next call. Allocates
    /// nothing after the first, for words of usual length.
    std::span<const Marker> build(const GhostMoment& moment, const GhostWords& words, const ProcessSettings& process,
                                  const Seam& seam, const GhostLook& look, const CueEye& eye, const glm::mat4& toWorld);

  private:
    /// A plane that faces the eye, from its lower corner nearest to the pool.
    struct Page {
        TextPlane plane;
        float side = 1; ///< 1: the page extends to the right of its corner, -1: to the left
        float row = 0;  ///< height above the pool, as a share of the eye's distance
    };

    /// Side and row of a page.
    struct Stand {
        float side = 1, row = 0;
    };

    static Page pageAt(const glm::vec3& pool, const CueEye& eye, float side, float row);
    static Page pageFor(const glm::vec3& place, const CueEye& eye, std::span<const Stand> stands, float width,
                        float height);
    float addWords(const GhostWords& words, const glm::vec3& pool, float side, const GhostLook& look, const CueEye& eye,
                   const glm::mat4& toWorld);
    void addName(const glm::vec3& end, float side, float row, const GhostLook& look, const CueEye& eye,
                 const glm::mat4& toWorld);
    void addGround(const Page& page, float width, float height, float strength, const glm::mat4& toWorld);

    std::vector<Marker> markers_;
    std::vector<Solid> parts_;
    MarkerText text_;
};

} // namespace meltpool
