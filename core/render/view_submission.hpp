// Ways of drawing several views: all with one draw call if the driver supports that, else one after the other.
#pragma once

#include "core/render/view.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace meltpool {

/// Ways from the fastest to the simplest; all give one picture.
enum class ViewSubmission {
    viewports, ///< an instance a view, sent to its viewport by the vertex shader (GL_ARB_shader_viewport_layer_array)
    clipping,  ///< an instance a view, squeezed into its column and clipped at its sides
    passes,    ///< everything is drawn again for each view
};

constexpr std::array<ViewSubmission, 3> kViewSubmissions{ViewSubmission::viewports, ViewSubmission::clipping,
                                                         ViewSubmission::passes};

/// Returns "viewports", "clip distances", "passes".
std::string_view submissionName(ViewSubmission submission);

/// Features of the driver for drawing several views at once.
struct SubmissionOffer {
    bool viewportInVertexShader = false; ///< GL_ARB_shader_viewport_layer_array
    int viewports = 1;
    int clipDistances = 0;
};

/// Returns the offer of the current context.
SubmissionOffer submissionOffer();

/// Returns the reason why a driver with this offer cannot draw `views` views in this way; empty: it can.
std::string submissionObstacle(ViewSubmission submission, const SubmissionOffer& offer, int views);

/// The chosen way, and a sentence about it for people.
struct SubmissionChoice {
    ViewSubmission submission = ViewSubmission::passes;
    std::string sentence;
};

/// Returns the wanted way, or the best, if the driver supports it; else the next simpler one, with the reason.
SubmissionChoice chooseSubmission(std::optional<ViewSubmission> wanted, const SubmissionOffer& offer, int views);

/// The views that one draw call fills.
struct ViewBatch {
    int first = 0; ///< index of the first view in the frame's uniforms
    int count = 1; ///< views, one an instance
    ViewSubmission submission = ViewSubmission::passes;
};

/// Sets viewports and scissor boxes for a batch of the `views` views side by side in `whole`; without the scissor boxes
/// large points would reach into a neighbouring view. Leaves the scissor test on.
void aim(const ViewBatch& batch, const Viewport& whole, int views);

/// Returns the clip distance with which shaders/render/view.glsl cuts the metal at the section.
constexpr GLenum cutPlane(ViewSubmission submission) {
    return submission == ViewSubmission::clipping ? GL_CLIP_DISTANCE2 : GL_CLIP_DISTANCE0;
}

} // namespace meltpool
