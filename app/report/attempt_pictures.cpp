#include "app/report/attempt_pictures.hpp"

#include "core/render/camera.hpp"
#include "core/training/judging/section_measures.hpp"

#include <glm/trigonometric.hpp>

#include <optional>
#include <vector>

namespace meltpool {

namespace {

View viewOf(const CameraParameters& camera, float aspect) {
    Lens lens;
    lens.fieldOfView = glm::radians(camera.fieldOfView);
    const OrbitCamera orbit(glm::radians(camera.azimuth), glm::radians(camera.elevation), camera.distance);
    return orbit.view(lens, aspect);
}

/// Measures of the gauge on a section, drawn as for a judged station of the weld.
std::vector<SectionStroke> measureStrokes(const WeldSection& section, const WorkpieceParameters& workpiece,
                                          const View& view, const SceneView& scene) {
    const WeldKind kind = weldKindOf(workpiece);
    const WeldStation station = stationOf(section.figures, kind, section.cut.at());
    std::vector<SectionStroke> strokes;
    layOutMarks(sectionMarks(station, kind, section.map, section.cut.fusion, SectionFaces::of(workpiece)),
                layoutIn(view, scene.modelToWorld, scene.section.at), strokes);
    return strokes;
}

} // namespace

Image takePicture(Renderer& renderer, const PictureTarget& target, LessonScene& shown, const PictureLook& picture,
                  const std::function<void(SceneView&, const View&)>& adorn) {
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    const View view = viewOf(picture.camera, aspect);
    const Trainer& trainer = shown.trainer();
    SceneView scene = shown.view();
    if (!picture.look.showSource) scene.putTorchAway(); // in a weld the torch is the source
    std::optional<WeldSection> section;
    if (picture.sectionAt) {
        section = trainer.section(static_cast<double>(*picture.sectionAt));
        scene.section = {true, *picture.sectionAt, section ? &section->map : nullptr};
        scene.putTorchAway();
        scene.room.shown = false; // shows only the cut metal
    }
    lookThroughTable(scene, view);
    std::vector<SectionStroke> strokes;
    if (picture.measures && section) {
        strokes = measureStrokes(*section, trainer.lesson().workpiece, view, scene);
        scene.section.strokes = strokes;
    }
    if (adorn) adorn(scene, view);
    renderer.draw(scene, picture.look, {&view, 1}, target.target(), nullptr);
    return target.read();
}

} // namespace meltpool
