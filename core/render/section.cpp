#include "core/render/section.hpp"

#include "shaders/shared/render.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace meltpool {

namespace {

constexpr float kTexelsPerSpacing = 8;
constexpr int kLargestPicture = 1024;
constexpr GLuint kPosition = 0, kHeat = 1; // attributes and bindings

glm::ivec2 pictureSize(const glm::vec2& size, float spacing) {
    const glm::vec2 wanted = glm::ceil(size / spacing * kTexelsPerSpacing);
    const float shrink = std::min(1.0f, kLargestPicture / std::max({wanted.x, wanted.y, 1.0f}));
    return glm::max(glm::ivec2(wanted * shrink), glm::ivec2(1));
}

} // namespace

SectionFrame sectionFrame(const SectionView& section, const glm::vec3& boxMin, const glm::vec3& boxMax) {
    const glm::vec3 normal = glm::normalize(section.normal);
    const glm::vec3 upright = std::abs(normal.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    SectionFrame frame;
    frame.across = glm::normalize(glm::cross(upright, normal));
    frame.up = glm::cross(normal, frame.across);
    glm::vec2 low(std::numeric_limits<float>::max()), high(-low);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 at((corner & 1) != 0 ? boxMax.x : boxMin.x, (corner & 2) != 0 ? boxMax.y : boxMin.y,
                           (corner & 4) != 0 ? boxMax.z : boxMin.z);
        const glm::vec2 place(glm::dot(at, frame.across), glm::dot(at, frame.up));
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    frame.low = low;
    frame.size = high - low;
    return frame;
}

SectionPainter::SectionPainter(gl::ShaderLibrary& shaders)
    : gather_(shaders.load({"render/section_gather.vert", "render/section_gather.frag"})),
      draw_(shaders, "render/section.vert", "render/section.frag"),
      layout_("section particles"),
      empty_("section") {
    for (const GLuint attribute : {kPosition, kHeat}) {
        glEnableVertexArrayAttrib(layout_.name(), attribute);
        glVertexArrayAttribFormat(layout_.name(), attribute, 4, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(layout_.name(), attribute, attribute);
    }
}

void SectionPainter::gather(const SectionView& section, const ParticleView& particles, const glm::vec3& boxMin,
                            const glm::vec3& boxMax) {
    frame_ = sectionFrame(section, boxMin, boxMax);
    const glm::ivec2 size = pictureSize(frame_.size, section.spacing);
    if (!picture_ || picture_->sums.shape().width != size.x || picture_->sums.shape().height != size.y) {
        picture_.emplace();
        picture_->sums = gl::Texture("section sums", {.format = GL_RGBA32F, .width = size.x, .height = size.y});
        picture_->framebuffer.attach(GL_COLOR_ATTACHMENT0, picture_->sums);
        picture_->framebuffer.requireComplete();
    }
    const std::array<float, 4> nothing{};
    glBindFramebuffer(GL_FRAMEBUFFER, picture_->framebuffer.name());
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    if (particles.positions == nullptr || particles.count == 0) return;
    const gl::Buffer& heat = section.heat != nullptr ? *section.heat : *particles.positions;
    gather_.set("point", section.point);
    gather_.set("normal", glm::normalize(section.normal));
    gather_.set("across", frame_.across);
    gather_.set("up", frame_.up);
    gather_.set("corner", glm::vec4(frame_.low, frame_.size));
    gather_.set("reach", SECTION_REACH * section.spacing);
    gather_.set("texelsPerUnit", static_cast<float>(size.x) / frame_.size.x);
    gather_.set("peakIsTemperature", section.heat == nullptr ? 1 : 0);
    glVertexArrayVertexBuffer(layout_.name(), kPosition, particles.positions->name(), 0, sizeof(glm::vec4));
    glVertexArrayVertexBuffer(layout_.name(), kHeat, heat.name(), 0, sizeof(glm::vec4));
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    gather_.use();
    layout_.bind();
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(particles.count));
    glDisable(GL_PROGRAM_POINT_SIZE);
    glDisable(GL_BLEND);
}

void SectionPainter::draw(const SectionView& section, const ViewBatch& views, const RenderTarget& target) const {
    if (!picture_) return;
    const glm::vec3 normal = glm::normalize(section.normal);
    const gl::Program& program = draw_.use(target, views);
    program.set("origin", normal * glm::dot(section.point, normal));
    program.set("across", frame_.across);
    program.set("up", frame_.up);
    program.set("corner", glm::vec4(frame_.low, frame_.size));
    program.set("spacing", section.spacing);
    picture_->sums.bind(SECTION_UNIT);
    empty_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, views.count);
}

SectionZone SectionPainter::measure(double peak, double level) const {
    SectionZone zone;
    if (!picture_) return zone;
    const auto& shape = picture_->sums.shape();
    std::vector<glm::vec4> sums(static_cast<size_t>(shape.width) * static_cast<size_t>(shape.height));
    glGetTextureImage(picture_->sums.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(sums.size() * sizeof(glm::vec4)), sums.data());
    const glm::dvec2 texel = glm::dvec2(frame_.size) / glm::dvec2(shape.width, shape.height);
    int left = shape.width, right = -1;
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x) {
            const glm::vec4& sum =
                sums[static_cast<size_t>(y) * static_cast<size_t>(shape.width) + static_cast<size_t>(x)];
            if (sum.x < SECTION_INSIDE || static_cast<double>(sum.y) < peak * static_cast<double>(sum.x)) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            zone.area += texel.x * texel.y;
            const double bottom = static_cast<double>(frame_.low.y) + y * texel.y - level;
            zone.height = std::max(zone.height, bottom + texel.y);
            zone.depth = std::max(zone.depth, -bottom);
        }
    if (right >= left) zone.width = (right - left + 1) * texel.x;
    return zone;
}

} // namespace meltpool
