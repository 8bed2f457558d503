#include "core/render/surface_colours.hpp"

#include "core/gl/buffer.hpp"
#include "core/render/frame_block.hpp"
#include "core/render/look/heat_colours.hpp"
#include "core/render/look/material_presets.hpp"
#include "core/render/look/temperature_scale.hpp"
#include "shaders/shared/render.h"

#include <glm/vec4.hpp>

namespace meltpool {

std::vector<glm::vec3> surfaceColours(gl::ShaderLibrary& shaders, const SceneView& scene, LookParameters look,
                                      std::span<const glm::vec2> heats) {
    if (heats.empty()) return {};
    look.visorShade = 0;
    gl::Buffer frame("frame block", sizeof(FrameData)), material("material block", sizeof(MaterialData));
    frame.writeValue(makeFrame(scene, look));
    material.writeValue(scene.looks != nullptr ? physicalMaterial(*scene.looks)
                                               : presetMaterial(static_cast<MaterialLook>(look.material)));
    const gl::Texture scales = makeScaleTexture(), heat = makeHeatTexture();
    const gl::Buffer input("vertex heats", heats), output("vertex colours", heats.size() * sizeof(glm::vec4));
    frame.bindUniform(FRAME_BINDING);
    material.bindUniform(MATERIAL_BINDING);
    scales.bind(SCALE_UNIT);
    heat.bind(HEAT_UNIT);
    input.bindStorage(COLOURED_HEATS_BINDING);
    output.bindStorage(COLOURS_BINDING);
    shaders.compute("render/surface_colours.comp").dispatch(heats.size(), COLOURS_GROUP);
    std::vector<glm::vec3> colours;
    colours.reserve(heats.size());
    for (const glm::vec4& colour : output.read<glm::vec4>(heats.size()))
        colours.emplace_back(colour);
    return colours;
}

} // namespace meltpool
