#include "core/render/frame_block.hpp"

#include "core/render/look/heat_colours.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace meltpool {

namespace {

void addSection(FrameData& frame, const SceneView& scene) {
    // Some drivers apply clip distances even while they are disabled: without a section, a plane that cuts nothing
    // away.
    frame.cutOffset = 1;
    if (!scene.section.shown) return;
    const glm::vec3 point = scene.modelToWorld * glm::vec4(scene.section.at, 0.0f, 0.0f, 1.0f);
    frame.cutNormal = glm::normalize(glm::vec3(scene.modelToWorld[0]));
    frame.cutOffset = glm::dot(frame.cutNormal, point);
}

/// An arc burns in a hollow of the metal's surface: the outer part of a block gives no shadow.
void addShadowBoxes(FrameData& frame, const SceneView& scene) {
    // Depth of the hollow: share of the block's thickness; greatest, m.
    constexpr float kHollow = 0.2f, kDeepestHollow = 1e-3f;
    constexpr float kSoft = 0.4f, kLongestSoft = 3e-3f; // width of the soft edge, likewise
    const size_t count = std::min<size_t>(scene.blocks.size(), MOST_SHADOW_BOXES);
    frame.shadowBoxCount = static_cast<int>(count);
    for (size_t i = 0; i < count; ++i) {
        const WorkpieceBlock& block = scene.blocks[i];
        const glm::vec3 size = block.high - block.low;
        const float thickness = std::min({size.x, size.y, size.z});
        const float hollow = std::min(kHollow * thickness, kDeepestHollow);
        frame.shadowBoxes[i].low = block.low + hollow;
        frame.shadowBoxes[i].high = block.high - hollow;
        frame.shadowBoxes[i].fullDepth = std::min(kSoft * thickness, kLongestSoft);
    }
}

/// Adds the nearest cylinders and cones to the tool's tip, which come first among the solids.
void addTorchParts(FrameData& frame, const SceneView& scene) {
    constexpr float kConeWidth = 0.5f; // share of its base: a cone counts as the cylinder of about its size
    for (const Solid& solid : scene.solids) {
        if (frame.torchPartCount == MOST_TORCH_PARTS) return;
        const bool cone = solid.shape == SolidShape::cone;
        if (!cone && solid.shape != SolidShape::cylinder) continue; // finer ones have coarse replacements
        TorchPart& part = frame.torchParts[frame.torchPartCount++];
        part.from = solid.toWorld * glm::vec4(0, 0, 0.5f, 1);
        part.to = solid.toWorld * glm::vec4(0, 0, -0.5f, 1);
        part.radius = 0.5f * glm::length(glm::vec3(solid.toWorld[0])) * (cone ? kConeWidth : 1.0f);
        part.colour = solid.colour;
    }
}

void addRolledFaces(FrameData& frame, const RolledFaces& rolled) {
    static_assert(RolledFaces::kMost == MOST_ROLLED_PLATES);
    frame.rolledPartCount = static_cast<int>(rolled.count);
    frame.seamAcross = rolled.across;
    frame.groundHalf = rolled.ground;
    for (size_t i = 0; i < rolled.count; ++i) {
        frame.rolledParts[i].low = rolled.parts[i].low;
        frame.rolledParts[i].high = rolled.parts[i].high;
        frame.rolledParts[i].faces = rolled.parts[i].faces;
    }
}

/// Adds the place on the metal that the source heats, faintly before it does, and its burner's shadow.
void addSource(FrameData& frame, const SceneView& scene, bool shown) {
    constexpr glm::vec3 kWarm(0.34f, 0.12f, 0.03f), kCold(0.06f, 0.20f, 0.30f);
    constexpr float kOff = 0.5f, kShadow = 0.75f;
    frame.sourceReach = 1;
    if (!shown || !scene.source.shown) return;
    frame.source = scene.modelToWorld * glm::vec4(scene.source.position, 1);
    frame.sourceReach = scene.source.reach * frame.modelUnit;
    frame.sourceLight = (scene.source.cold ? kCold : kWarm) * (scene.source.on ? 1.0f : kOff);
    frame.sourceShadow = kShadow;
}

} // namespace

FrameData makeFrame(const SceneView& scene, const LookParameters& look) {
    const float unit = glm::length(glm::vec3(scene.modelToWorld[0]));
    const TemperatureMeaning& meaning = scene.temperature;
    const float range = std::max(meaning.hottest - meaning.coldest, 1e-6f);
    const float mushy = std::max(meaning.liquidus - meaning.solidus, 1.0f); // a pure metal changes its look over 1 K
    FrameData frame{};
    frame.modelToWorld = scene.modelToWorld;
    frame.modelUnit = unit;
    // The lamp does not turn with the model.
    frame.lamp = glm::vec3(scene.modelToWorld[3]) + unit * look.lightPosition;
    frame.lampDirection = glm::normalize(frame.lamp - glm::vec3(scene.modelToWorld[3]));
    frame.ambient = look.ambient;
    frame.diffuse = look.diffuse;
    frame.specular = look.specular;
    frame.shininess = look.shininess;
    // Welding filters are green: they pass the little light they do at the wavelengths to which the eye is most
    // sensitive.
    const glm::vec3 filter =
        look.visorShade > 0 ? filterShare(look.visorShade) * glm::vec3(0.75f, 1.1f, 0.5f) : glm::vec3(1.0f);
    frame.exposure = look.exposure * filter;
    frame.coldest = meaning.coldest;
    frame.perTemperatureRange = 1.0f / range;
    frame.solidus = meaning.solidus;
    frame.perMushyRange = meaning.kelvin ? 1.0f / mushy : 0.0f;
    frame.colourMode = static_cast<float>(look.colours);
    frame.scaleRow = static_cast<float>(std::max(look.colours - kTemperatureColours, 0));
    frame.dullness = look.dullness;
    frame.glowSoftening = look.visorShade > 0 ? 0.0f : look.glowSoftening;
    frame.pointRadius = look.pointSize * unit;
    frame.perCubeWidth = 1.0f / scene.cubeWidth;
    frame.boxMin = scene.boxMin;
    frame.boxMax = scene.boxMax;
    addSection(frame, scene);
    addShadowBoxes(frame, scene);
    addTorchParts(frame, scene);
    addRolledFaces(frame, scene.rolled);
    addSource(frame, scene, look.showSource);
    frame.oxideRadius = scene.oxideRadius;
    frame.arc = scene.modelToWorld * glm::vec4(scene.arc.position, 1.0f);
    frame.arcMinDistanceSquared = scene.arc.radius * scene.arc.radius;
    frame.arcLight = scene.arc.intensity * (look.visorShade > 0 ? 1.0f : look.arcLight);
    return frame;
}

ViewData makeViewData(const View& view, const Viewport& viewport) {
    ViewData data{};
    data.worldToClip = view.eyeToClip * view.worldToEye;
    data.worldToEye = view.worldToEye;
    const glm::mat4 toWorld = glm::mat4(glm::transpose(glm::mat3(view.worldToEye)));
    data.clipToDirection = toWorld * glm::inverse(view.eyeToClip);
    const auto height = static_cast<float>(viewport.height);
    data.eye = view.eye;
    data.pixelsPerUnit = 0.5f * height * view.eyeToClip[1][1];
    data.size = {viewport.width, viewport.height};
    data.corner = {viewport.x, viewport.y};
    data.arcSeen = 1;
    return data;
}

} // namespace meltpool
