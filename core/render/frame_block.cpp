#include "core/render/frame_block.hpp"

#include "core/render/look/heat_colours.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace meltpool {

FrameData makeFrame(const SceneView& scene, const LookParameters& look) {
    const float unit = glm::length(glm::vec3(scene.modelToWorld[0]));
    const TemperatureMeaning& meaning = scene.temperature;
    const float range = std::max(meaning.hottest - meaning.coldest, 1e-6f);
    const float mushy = std::max(meaning.liquidus - meaning.solidus, 1.0f); // a pure metal still fades over 1 K
    FrameData frame{};
    frame.modelToWorld = scene.modelToWorld;
    frame.light = scene.modelToWorld * glm::vec4(look.lightPosition, 1.0f);
    const glm::vec3 origin = scene.modelToWorld[3];
    frame.lampWay = glm::vec4(glm::normalize(glm::vec3(frame.light) - origin), 0.0f);
    frame.phong = {look.ambient, look.diffuse, look.specular, look.shininess};
    // Welding filters are green: what little they pass lies where the eye sees best.
    const glm::vec3 filter =
        look.visorShade > 0 ? filterShare(look.visorShade) * glm::vec3(0.75f, 1.1f, 0.5f) : glm::vec3(1.0f);
    frame.tone = glm::vec4(look.exposure * filter, unit);
    frame.temperature = {meaning.coldest, 1.0f / range, meaning.solidus, meaning.kelvin ? 1.0f / mushy : 0.0f};
    frame.colours = {look.colours, std::max(look.colours - kTemperatureColours, 0), 0, 0};
    frame.boxMin = glm::vec4(scene.boxMin, 1.0f);
    frame.boxMax = glm::vec4(scene.boxMax, 1.0f);
    // Some drivers cut whether or not they are told to: without a section, a plane that takes nothing away.
    frame.cut = {0, 0, 0, 1};
    if (scene.section.shown) {
        const glm::vec3 normal = glm::normalize(glm::mat3(scene.modelToWorld) * scene.section.normal);
        const glm::vec3 point = scene.modelToWorld * glm::vec4(scene.section.point, 1.0f);
        frame.cut = glm::vec4(normal, glm::dot(normal, point));
    }
    const glm::vec3 arcLight = scene.arc.intensity * (look.visorShade > 0 ? 1.0f : look.arcLight);
    frame.arc = glm::vec4(glm::vec3(scene.modelToWorld * glm::vec4(scene.arc.position, 1.0f)),
                          scene.arc.radius * scene.arc.radius);
    frame.arcLight = glm::vec4(arcLight, 0.0f);
    frame.detail = {look.dullness, look.pointSize * unit, 1.0f / scene.cubeWidth, 0.0f};
    return frame;
}

ViewData makeViewData(const View& view, const Viewport& viewport) {
    ViewData data{};
    data.worldToClip = view.eyeToClip * view.worldToEye;
    data.worldToEye = view.worldToEye;
    const glm::mat4 toWorld = glm::mat4(glm::transpose(glm::mat3(view.worldToEye)));
    data.clipToWay = toWorld * glm::inverse(view.eyeToClip);
    const auto height = static_cast<float>(viewport.height);
    data.eye = glm::vec4(view.eye, 0.5f * height * view.eyeToClip[1][1]);
    data.size = {viewport.width, viewport.height, viewport.x, viewport.y};
    return data;
}

} // namespace meltpool
