#include "core/render/effects/worn_visor.hpp"

#include "core/base/words.hpp"
#include "core/render/look/heat_colours.hpp"

namespace meltpool {

namespace {

constexpr double kMetal = 0.3; // reflectance of steel in the lamps' light; no source: chosen

} // namespace

VisorSettings visorOf(const LookParameters& look) {
    return {look.visorShade, look.visorLightShade, look.visorSwitching};
}

void WornVisor::update(const SeenArc& arc, const VisorSettings& visor, const LookParameters& look, double elapsed) {
    filter_.update(arc.intensity > 0, elapsed, visor);
    const float shade = filter_.shade(visor);
    EyeScene scene;
    scene.arc = arc.intensity;
    scene.height = arc.height;
    scene.room = kMetal * static_cast<double>(look.ambient + 0.5F * look.diffuse);
    scene.passed = static_cast<double>(filterShare(shade));
    scene.drawn = shade > 0 ? 1 : static_cast<double>(look.arcLight);
    scene.exposed = arc.inSight && shade < kProtects;
    scene.towards = arc.towards;
    eye_.update(scene, elapsed);
    if (eye_.exposed()) worn_ = visor.darkShade > 0;
    tell();
}

void WornVisor::wear(const VisorSettings& visor, LookParameters& look) const {
    look.visorShade = filter_.shade(visor);
    if (look.adaptation) look.exposure *= eye_.exposure();
}

void WornVisor::tell() {
    text_.clear();
    if (eye_.looked() < kLeastLook || eye_.sinceLook() > kTold) return;
    appendPhrase(text_, worn_ ? "visor.still_light" : "visor.none", {{"seconds", PhraseNumber(eye_.looked(), 1)}});
}

} // namespace meltpool
