// Cues as they are drawn: a few markers on a board beside the torch's tip that faces the eye, and dashes on the seam
// ahead. None of them covers the pool.
#pragma once

#include "core/render/solids.hpp"
#include "core/training/feedback/cues.hpp"
#include "core/training/judging/seam.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// m; a disc of this radius on the seam, about the place where the torch points, stays free of cues.
inline constexpr double kPoolDisc = 8e-3;

/// Of the cues' board, over its distance from the eye.
inline constexpr float kCueBoardHeight = 0.12F;

/// Where the torch welds; workpiece frame, m.
struct CuePose {
    double place = 0; ///< along the seam
    double aim = 0;   ///< across it
    double line = 0;  ///< across it, where the lesson wants the torch aimed
    glm::vec3 axis{0, -1, 0};
    int direction = 0; ///< of travel: +1 towards growing places, -1, 0 while it is not known
    double from = 0;   ///< of the wanted seam, places
    double to = 0;
};

/// Who looks: one camera, or the middle between two eyes that are up to a quarter of their distance from the pool
/// apart. Workpiece frame, m.
struct CueEye {
    glm::vec3 position{0};
    glm::vec3 up{0, 1, 0};                ///< of the picture; need not be a unit vector, must not point along the view
    std::optional<glm::mat4> toClip = {}; ///< from the workpiece's frame; none: the picture has no edges
};

/// Whether `point` hides, from an eye there, a part of the disc about `centre` with unit normal `normal`.
bool coversDisc(const glm::vec3& eye, const glm::vec3& point, const glm::vec3& centre, const glm::vec3& normal,
                float radius);

/// Draws cues. The board stands nearer to the eye than the pool, on the side that the torch travels to; where workpiece
/// or torch are in the way or the picture ends, lower, on the other side, or nearer still. It grows with the eye's
/// distance. Its four fields stay where they are:
///
///     distance  angles
///     aim       speed
///
/// The marks of distance, aim and speed move along the torch, across and along the seam as these lie in the picture;
/// the light part of a bar is the inner band, its ends are the outer one. In the disc of the angles the dot is where
/// the torch's handle leans to. Above them stands the sign that the arc is out.
class CueShapes {
  public:
    CueShapes();

    /// The markers in the world, from the workpiece's frame by `toWorld`; valid until the next call. Allocates nothing
    /// after the first. `blocks`: of the workpiece.
    std::span<const Marker> build(const CueList& cues, const Seam& seam, const CuePose& pose, const CueEye& eye,
                                  std::span<const WorkpieceBlock> blocks, const glm::mat4& toWorld);

  private:
    /// A plane that faces the eye. Fields are squares of edge `cell`, counted to the outside and up.
    struct Board {
        glm::vec3 origin{0}; ///< the inner lower corner of the first field
        glm::vec3 right{1, 0, 0};
        glm::vec3 up{0, 1, 0};
        glm::vec3 toEye{0, 0, 1};
        glm::vec3 outwards{1, 0, 0}; ///< right or left
        float cell = 0;

        glm::vec3 field(float column, float row) const { return origin + (outwards * column + up * row) * cell; }
        /// Unit vector on the board, as the direction lies in the picture.
        glm::vec3 shown(const glm::vec3& direction, const glm::vec3& otherwise) const;
    };

    /// Where a board stands beside the pool.
    struct Stand {
        float side = 1; ///< 1 right, -1 left
        float row = 0;  ///< of the board's lower edge, in fields over the pool
        float lift = 1; ///< over the usual one
    };

    static Board boardAt(const Stand& stand, const glm::vec3& pool, const CueEye& eye);
    static int badness(const Board& board, const CuePose& pose, const glm::vec3& pool, const CueEye& eye,
                       std::span<const WorkpieceBlock> blocks);
    Board boardFor(const CuePose& pose, const SeamFrame& frame, const glm::vec3& pool, const CueEye& eye,
                   std::span<const WorkpieceBlock> blocks);
    void addTile(const Board& board, const glm::vec3& middle, double opacity);
    void addBar(const Board& board, const Cue& cue, const glm::vec3& middle, const glm::vec3& along);
    void addAngles(const Board& board, const CueList& cues, const SeamFrame& frame, int direction);
    void addArcSign(const Board& board, const Cue& cue, const glm::vec3& away);
    void addSeam(const Cue& cue, const Seam& seam, const CuePose& pose, const glm::vec3& pool, const CueEye& eye);
    void add(SolidShape shape, const glm::mat4& place, const glm::vec3& colour, double opacity);

    std::vector<Marker> markers_;
    glm::mat4 toWorld_{1.0f};
    Stand stand_;      ///< of the last board
    float wanted_ = 0; ///< side that the torch travelled to then
};

} // namespace meltpool
