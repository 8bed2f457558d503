// Draws the cues: a few markers on a board that faces the eye, next to the torch's tip, and dashes on the seam ahead.
// None of them covers the pool.
#pragma once

#include "core/render/solids.hpp"
#include "core/training/feedback/cues.hpp"
#include "core/training/feedback/marker_text.hpp"
#include "core/training/judging/seam.hpp"
#include "core/training/judging/welded_places.hpp"
#include "core/weld/workpiece/workpiece.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace meltpool {

/// m; a disc of this radius on the seam, around the torch's target, stays free of cues.
inline constexpr double kPoolDisc = 8e-3;

/// Height of the cues' board over its distance from the eye.
inline constexpr float kCueBoardHeight = 0.12F;

/// Pose of the torch at the weld; workpiece frame, m.
struct CuePose {
    double place = 0; ///< place along the seam
    double aim = 0;   ///< aim across the seam
    double line = 0;  ///< the lesson's aim across the seam
    glm::vec3 axis{0, -1, 0};
    int direction = 0; ///< direction of travel: +1 towards growing places, -1, 0 while unknown
    double from = 0;   ///< places of the wanted seam
    double to = 0;
};

/// The viewer: one camera, or the middle between two eyes whose distance from each other is up to a quarter of their
/// distance from the pool. Workpiece frame, m.
struct CueEye {
    glm::vec3 position{0};
    glm::vec3 up{0, 1, 0};                ///< up in the picture; need not be a unit vector, must not point along the
                                          ///< view
    std::optional<glm::mat4> toClip = {}; ///< transform from the workpiece's frame; empty: the picture has no edges
    std::optional<glm::vec4> table = {};  ///< unit normal of the table's top and its place along it: nothing is seen
                                          ///< below; empty: the workpiece stands over it
    std::span<const Solid> hands = {};    ///< torch, gloves and forearms of a person whose hands are tracked; world
};

/// Name of a cue's field on the board.
struct CueLabel {
    CueKind kind = CueKind::speed;
    glm::vec3 place{0}; ///< middle of the field's outer edge, upper or lower; world
    glm::vec3 end{0};   ///< right end of that edge
    bool above = false; ///< the edge is the upper one
    double opacity = 1; ///< of the cue
    int correction = 0; ///< beyond the band: direction in which the value has to go; else 0
};

/// Words at a field of the board; empty ones are not drawn.
struct CueWords {
    std::string_view name;
    std::string_view less = {}; ///< in place of the name beyond the band, where the value has to become less
    std::string_view more = {}; ///< likewise, where it has to become more

    /// Returns the word for a correction as in CueLabel.
    std::string_view shown(int correction) const {
        const std::string_view wanted = correction < 0 ? less : correction > 0 ? more : name;
        return wanted.empty() ? name : wanted;
    }
};

/// Words of the board's fields, in the order of CueKind.
using CueNames = std::array<CueWords, kCueKinds.size()>;

/// True if `point`, seen from `eye`, hides a part of the disc around `centre` with unit normal `normal`.
bool coversDisc(const glm::vec3& eye, const glm::vec3& point, const glm::vec3& centre, const glm::vec3& normal,
                float radius);

/// Draws cues. The board is nearer to the eye than the pool, on the side of the travel direction; if workpiece, torch,
/// hand, table or the picture's edge is in the way, it is lower, on the other side, or nearer still. It grows with the
/// eye's distance. Its four fields keep their places:
///
///     distance  angles
///     aim       speed
///
/// The marks of distance, aim and speed move in the picture's directions along the torch, across the seam and along the
/// seam; the light part of a bar is the inner band, its ends are the outer one. In the disc of the angles the dot shows
/// the lean of the torch's handle. Above them is the sign for an arc that is out.
class CueShapes {
  public:
    CueShapes();

    /// Sets the names that the fields of the next boards carry at their outer edges; borrowed. None at first.
    void setNames(const CueNames& names);

    /// Builds the markers in the world, from the workpiece's frame by `toWorld`; valid until the next call. Allocates
    /// nothing after the first. `blocks`: blocks of the workpiece. `welded`: places without dashes; may be null.
    std::span<const Marker> build(const CueList& cues, const Seam& seam, const CuePose& pose, const CueEye& eye,
                                  std::span<const WorkpieceBlock> blocks, const glm::mat4& toWorld,
                                  const WeldedPlaces* welded = nullptr);

    /// Number of the last markers of the last build() that are the board: all but the dashes.
    size_t boardMarkers() const { return markers_.size() - dashes_; }
    /// Fields of that board.
    std::span<const CueLabel> labels() const { return {labels_.data(), labelCount_}; }
    /// Side of the pool on which that board is: 1 right, -1 left, 0 without fields.
    float boardSide() const { return labelCount_ > 0 ? stand_.side : 0; }

  private:
    /// A plane that faces the eye. Its fields are squares of edge `cell`, counted outwards and upwards.
    struct Board {
        glm::vec3 origin{0}; ///< inner lower corner of the first field
        glm::vec3 right{1, 0, 0};
        glm::vec3 up{0, 1, 0};
        glm::vec3 toEye{0, 0, 1};
        glm::vec3 outwards{1, 0, 0}; ///< to the right or to the left
        float cell = 0;

        glm::vec3 field(float column, float row) const { return origin + (outwards * column + up * row) * cell; }
        /// Unit vector on the board for the direction's projection in the picture.
        glm::vec3 shown(const glm::vec3& direction, const glm::vec3& otherwise) const;
    };

    /// Position of a board next to the pool.
    struct Stand {
        float side = 1; ///< 1 right, -1 left
        float row = 0;  ///< height of the board's lower edge above the pool, in fields
        float lift = 1; ///< factor of the usual lift
    };

    static Board boardAt(const Stand& stand, const glm::vec3& pool, const CueEye& eye);
    bool behindHands(const glm::vec3& point, const CueEye& eye) const;
    bool hidden(const glm::vec3& point, const CueEye& eye, std::span<const WorkpieceBlock> blocks) const;
    int badness(const Board& board, const CuePose& pose, const glm::vec3& pool, const CueEye& eye,
                std::span<const WorkpieceBlock> blocks, int enough) const;
    Board boardFor(const CuePose& pose, const SeamFrame& frame, const glm::vec3& pool, const CueEye& eye,
                   std::span<const WorkpieceBlock> blocks);
    void addTile(const Board& board, const glm::vec3& middle, const Cue& cue, double opacity);
    void addName(const Board& board, const CueLabel& label, const glm::vec3& edge);
    void addBar(const Board& board, const Cue& cue, const glm::vec3& middle, const glm::vec3& along);
    void addAngles(const Board& board, const CueList& cues, const SeamFrame& frame, int direction);
    void addArcSign(const Board& board, const Cue& cue, const glm::vec3& away);
    void addSeam(const Cue& cue, const Seam& seam, const CuePose& pose, const glm::vec3& pool, const CueEye& eye,
                 const WeldedPlaces* welded);
    void add(SolidShape shape, const glm::mat4& place, const glm::vec3& colour, double opacity);

    std::vector<Marker> markers_;
    size_t dashes_ = 0; ///< the first of the markers
    std::array<CueLabel, 4> labels_;
    size_t labelCount_ = 0;
    CueNames names_;
    float nameFigure_ = 0; ///< height of a figure in the names, as a share of a field's edge; 0 without names
    MarkerText text_;
    glm::mat4 toWorld_{1.0f};
    Stand stand_;      ///< place of the last board
    float wanted_ = 0; ///< side of the travel direction at that time
};

} // namespace meltpool
