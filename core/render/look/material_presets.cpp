#include "core/render/look/material_presets.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/gtx/component_wise.hpp>

#include <algorithm>

namespace meltpool {

namespace {

glm::vec3 shown(const glm::vec3& light) {
    return glm::pow(light, glm::vec3(1 / 2.2f));
}

constexpr float kIceIndex = 1.31f;
constexpr float kWaxIndex = 1.44f;

/// One state of a material.
struct Finish {
    glm::vec3 colour; ///< displayed colour (sRGB)
    float mirror;     ///< share of the mirror image
};

MaterialData makeMaterial(const Finish& solid, const Finish& liquid, glm::vec3 mirrorColour, float refractiveIndex) {
    MaterialData data{};
    data.solidColour = solid.colour;
    data.solidMirror = solid.mirror;
    data.liquidColour = liquid.colour;
    data.liquidMirror = liquid.mirror;
    data.mirrorColour = mirrorColour;
    data.refractiveIndex = refractiveIndex;
    // The highlight of a metal has most of the metal's colour; that of other materials is white.
    data.highlight = glm::mix(glm::vec3(1.0f), mirrorColour, 0.7f);
    return data;
}

MaterialData makeMetal(const Finish& solid, const Finish& liquid, glm::vec3 mirrorColour) {
    return makeMaterial(solid, liquid, mirrorColour, 1.0f);
}

MaterialData makeTranslucent(const Finish& solid, const Finish& liquid, float refractiveIndex, glm::vec3 absorption,
                             float scattering) {
    MaterialData data = makeMaterial(solid, liquid, glm::vec3(1.0f), refractiveIndex);
    data.absorption = absorption;
    data.scattering = scattering;
    return data;
}

/// Returns the reflectance of an opaque surface, which reflects all light that it does not absorb, and absorbs as much
/// as it emits (Kirchhoff): the brightest channel has this reflectance, the others keep the colour.
glm::vec3 reflectance(const glm::vec3& colour, float emissivity) {
    return colour * ((1 - emissivity) / std::max(glm::compMax(colour), 1e-3f));
}

} // namespace

MaterialData presetMaterial(MaterialLook look) {
    switch (look) {
    case kCopper:
        return makeMetal({{0.78f, 0.48f, 0.36f}, 0.34f}, {{0.42f, 0.20f, 0.13f}, 0.66f}, {1.0f, 0.62f, 0.48f});
    case kGold:
        return makeMetal({{0.86f, 0.66f, 0.27f}, 0.40f}, {{0.50f, 0.33f, 0.09f}, 0.70f}, {1.0f, 0.78f, 0.34f});
    case kWax:
        return makeTranslucent({{0.90f, 0.79f, 0.57f}, 0.04f}, {{0.92f, 0.63f, 0.24f}, 0.04f}, kWaxIndex,
                               {2.2f, 4.6f, 9.0f}, 0.0f);
    case kIce:
        return makeTranslucent({{0.90f, 0.95f, 0.97f}, 0.02f}, {{0.85f, 0.92f, 0.95f}, 0.02f}, kIceIndex,
                               {1.10f, 0.30f, 0.16f}, 6.0f);
    case kSolder:
        break;
    }
    return makeMetal({glm::vec3(0.7f), 0.3f}, {glm::vec3(0.2f), 0.6f}, glm::vec3(1.0f));
}

MaterialData physicalMaterial(const MaterialLooks& looks, const FreezingRipples& ripples) {
    if (physicalKind(looks) != SurfaceKind::metal) {
        MaterialData data = presetMaterial(physicalKind(looks) == SurfaceKind::ice ? kIce : kWax);
        data.refractiveIndex = looks.refractiveIndex;
        return data;
    }
    // The rougher the surface, the more of its reflection is spread so widely that it looks diffuse.
    const auto mirrorShare = [](float roughness) { return glm::mix(0.75f, 0.2f, glm::clamp(roughness, 0.0f, 1.0f)); };
    MaterialData data = makeMaterial({shown(looks.solidColour), mirrorShare(looks.solidRoughness)},
                                     {shown(looks.liquidColour * 0.35f), mirrorShare(looks.liquidRoughness)},
                                     glm::mix(looks.solidColour, glm::vec3(1.0f), 0.15f), looks.refractiveIndex);
    data.oxideTint = looks.heatTint;
    data.cleanReflectance = reflectance(looks.solidColour, looks.cleanEmissivity);
    data.cleanEmissivity = looks.cleanEmissivity;
    data.liquidReflectance = reflectance(looks.liquidColour, looks.liquidEmissivity);
    data.liquidEmissivity = looks.liquidEmissivity;
    data.scaledEmissivity = looks.scaledEmissivity;
    data.solidRoughness = looks.solidRoughness;
    data.liquidRoughness = looks.liquidRoughness;
    data.rippleFrequency = looks.rippleFrequency > 0 ? looks.rippleFrequency : ripples.frequency;
    data.rippleHeight = looks.rippleHeight * ripples.height;
    data.millScale = looks.millScale;
    return data;
}

SurfaceKind presetKind(MaterialLook look) {
    return look == kIce ? SurfaceKind::ice : look == kWax ? SurfaceKind::wax : SurfaceKind::metal;
}

SurfaceKind physicalKind(const MaterialLooks& looks) {
    if (looks.translucency <= 0) return SurfaceKind::metal;
    return looks.translucency > 0.6f ? SurfaceKind::ice : SurfaceKind::wax;
}

} // namespace meltpool
