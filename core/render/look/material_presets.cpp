#include "core/render/look/material_presets.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

namespace meltpool {

namespace {

glm::vec3 shown(const glm::vec3& light) {
    return glm::pow(light, glm::vec3(1 / 2.2f));
}

constexpr float kIceIndex = 1.31f;
constexpr float kWaxIndex = 1.44f;

} // namespace

namespace {

MaterialData presetBase(MaterialLook look) {
    switch (look) {
    case kCopper:
        return {.solid = {0.78f, 0.48f, 0.36f, 0.34f},
                .liquid = {0.42f, 0.20f, 0.13f, 0.66f},
                .mirror = {1.0f, 0.62f, 0.48f, 1.0f},
                .glint = {},
                .heat = {},
                .absorb = {}};
    case kGold:
        return {.solid = {0.86f, 0.66f, 0.27f, 0.40f},
                .liquid = {0.50f, 0.33f, 0.09f, 0.70f},
                .mirror = {1.0f, 0.78f, 0.34f, 1.0f},
                .glint = {},
                .heat = {},
                .absorb = {}};
    case kWax:
        return {.solid = {0.90f, 0.79f, 0.57f, 0.04f},
                .liquid = {0.92f, 0.63f, 0.24f, 0.04f},
                .mirror = {1.0f, 1.0f, 1.0f, kWaxIndex},
                .glint = {},
                .heat = {},
                .absorb = {2.2f, 4.6f, 9.0f, 0.0f}};
    case kIce:
        return {.solid = {0.90f, 0.95f, 0.97f, 0.02f},
                .liquid = {0.85f, 0.92f, 0.95f, 0.02f},
                .mirror = {1.0f, 1.0f, 1.0f, kIceIndex},
                .glint = {},
                .heat = {},
                .absorb = {1.10f, 0.30f, 0.16f, 6.0f}};
    case kSolder:
        break;
    }
    return {.solid = {0.7f, 0.7f, 0.7f, 0.3f},
            .liquid = {0.2f, 0.2f, 0.2f, 0.6f},
            .mirror = {1.0f, 1.0f, 1.0f, 1.0f},
            .glint = {},
            .heat = {},
            .absorb = {}};
}

/// A metal's highlight has most of its colour, everything else mirrors the lamp white.
MaterialData withGlint(MaterialData data) {
    data.glint = glm::mix(glm::vec4(1.0f), data.mirror, 0.7f);
    return data;
}

} // namespace

MaterialData presetMaterial(MaterialLook look) {
    return withGlint(presetBase(look));
}

MaterialData physicalMaterial(const MaterialLooks& looks) {
    if (physicalKind(looks) != SurfaceKind::metal) {
        MaterialData data = presetMaterial(physicalKind(looks) == SurfaceKind::ice ? kIce : kWax);
        data.mirror.w = looks.refractiveIndex;
        return data;
    }
    // The duller the surface, the more of its reflectance is spread so far that it reads as paint and not as image.
    const auto mirrorShare = [&](float roughness) { return glm::mix(0.75f, 0.2f, glm::clamp(roughness, 0.0f, 1.0f)); };
    return withGlint({.solid = glm::vec4(shown(looks.solidColour), mirrorShare(looks.solidRoughness)),
                      .liquid = glm::vec4(shown(looks.liquidColour * 0.35f), mirrorShare(looks.liquidRoughness)),
                      .mirror = glm::vec4(glm::mix(looks.solidColour, glm::vec3(1.0f), 0.15f), looks.refractiveIndex),
                      .glint = {},
                      .heat = {looks.visibleEmissivity, looks.heatTint, 0, 0},
                      .absorb = {}});
}

SurfaceKind presetKind(MaterialLook look) {
    return look == kIce ? SurfaceKind::ice : look == kWax ? SurfaceKind::wax : SurfaceKind::metal;
}

SurfaceKind physicalKind(const MaterialLooks& looks) {
    if (looks.translucency <= 0) return SurfaceKind::metal;
    return looks.translucency > 0.6f ? SurfaceKind::ice : SurfaceKind::wax;
}

} // namespace meltpool
