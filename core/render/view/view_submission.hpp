// How several views reach the pipeline: all with one draw call where the driver can, else one after the other.
#pragma once

#include "core/render/view/view.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// From the best to the plainest; all give the same picture.
enum class ViewSubmission {
    viewports, ///< an instance a view, sent to its viewport by the vertex shader (GL_ARB_shader_viewport_layer_array)
    clipping,  ///< an instance a view, squeezed into its column and cut off there by clip distances
    passes,    ///< everything anew for each view
};

constexpr std::array<ViewSubmission, 3> kViewSubmissions{ViewSubmission::viewports, ViewSubmission::clipping,
                                                         ViewSubmission::passes};

/// "viewports", "clip distances", "passes".
std::string_view submissionName(ViewSubmission submission);

/// What a driver has for drawing several views at once.
struct SubmissionOffer {
    bool viewportInVertexShader = false; ///< GL_ARB_shader_viewport_layer_array
    int viewports = 1;
    int clipDistances = 0;
};

/// Of the current context.
SubmissionOffer submissionOffer();

/// Why a driver with this offer cannot draw `views` views so; empty: it can.
std::string submissionObstacle(ViewSubmission submission, const SubmissionOffer& offer, int views);

/// What was chosen, and in words what a person should know about it.
struct SubmissionChoice {
    ViewSubmission submission = ViewSubmission::passes;
    std::string sentence;
};

/// The wanted one, or the best, where the driver can; else the next one down the list, saying why.
SubmissionChoice chooseSubmission(std::optional<ViewSubmission> wanted, const SubmissionOffer& offer, int views);

/// The views that one draw call fills.
struct ViewBatch {
    int first = 0; ///< index of the first view in the frame's uniforms
    int count = 1; ///< views, one an instance
    ViewSubmission submission = ViewSubmission::passes;
};

/// Sends what is drawn for these views, of `views` side by side in `whole`, to where they belong; no point that is
/// larger than a pixel reaches over into a neighbour. Leaves the scissor test on.
void aim(const ViewBatch& batch, const Viewport& whole, int views);

/// The clip distance by which shaders/render/view.glsl cuts the metal open.
constexpr GLenum cutPlane(ViewSubmission submission) {
    return submission == ViewSubmission::clipping ? GL_CLIP_DISTANCE2 : GL_CLIP_DISTANCE0;
}

} // namespace meltpool
