#include "core/render/view_submission.hpp"

namespace meltpool {

namespace {

constexpr const char* kViewportExtension = "GL_ARB_shader_viewport_layer_array";
constexpr int kClipDistances = 3; // two sides of a column, and the section

bool offers(std::string_view extension) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name != nullptr && extension == reinterpret_cast<const char*>(name)) return true;
    }
    return false;
}

int limit(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

const char* description(ViewSubmission submission) {
    switch (submission) {
    case ViewSubmission::viewports:
        return "all views with one draw call, each in its viewport";
    case ViewSubmission::clipping:
        return "all views with one draw call, side by side between clip distances";
    case ViewSubmission::passes:
        break;
    }
    return "one view after the other";
}

} // namespace

std::string_view submissionName(ViewSubmission submission) {
    switch (submission) {
    case ViewSubmission::viewports:
        return "viewports";
    case ViewSubmission::clipping:
        return "clip distances";
    case ViewSubmission::passes:
        break;
    }
    return "passes";
}

SubmissionOffer submissionOffer() {
    return {offers(kViewportExtension), limit(GL_MAX_VIEWPORTS), limit(GL_MAX_CLIP_DISTANCES)};
}

std::string submissionObstacle(ViewSubmission submission, const SubmissionOffer& offer, int views) {
    if (submission == ViewSubmission::viewports) {
        if (!offer.viewportInVertexShader) return std::string("the graphics driver has no ") + kViewportExtension;
        if (offer.viewports < views)
            return "the graphics driver has only " + std::to_string(offer.viewports) + " viewports";
    }
    if (submission == ViewSubmission::clipping && offer.clipDistances < kClipDistances)
        return "the graphics driver has only " + std::to_string(offer.clipDistances) + " clip distances";
    return {};
}

SubmissionChoice chooseSubmission(std::optional<ViewSubmission> wanted, const SubmissionOffer& offer, int views) {
    SubmissionChoice choice;
    for (const ViewSubmission each : kViewSubmissions) {
        if (wanted && each < *wanted) continue;
        const std::string obstacle = submissionObstacle(each, offer, views);
        if (obstacle.empty()) {
            choice.submission = each;
            choice.sentence = description(each) + choice.sentence;
            return choice;
        }
        choice.sentence += "; " + obstacle;
    }
    return choice; // unreachable: passes need nothing
}

void aim(const ViewBatch& batch, const Viewport& whole, int views) {
    glEnable(GL_SCISSOR_TEST);
    if (batch.submission != ViewSubmission::viewports) {
        Viewport all = columnOf(whole, batch.first, views);
        all.width *= batch.count;
        glViewport(all.x, all.y, all.width, all.height);
        glScissor(all.x, all.y, all.width, all.height);
        return;
    }
    for (int i = 0; i < batch.count; ++i) {
        const Viewport column = columnOf(whole, batch.first + i, views);
        const auto index = static_cast<GLuint>(batch.first + i);
        glViewportIndexedf(index, static_cast<float>(column.x), static_cast<float>(column.y),
                           static_cast<float>(column.width), static_cast<float>(column.height));
        glScissorIndexed(index, column.x, column.y, column.width, column.height);
    }
}

} // namespace meltpool
