// The lesson that window and headset share: its values, and the Trainer that runs it.
#pragma once

#include "app/session/controls.hpp"
#include "app/session/lesson_figures.hpp"
#include "app/session/parameter_section.hpp"
#include "app/session/step_clock.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace meltpool {

/// A lesson's values as the menus group them. They point into the lesson, which must outlive them unmoved; the defaults
/// are what the lesson held when this was made.
struct LessonSections {
    explicit LessonSections(Lesson& lesson);

    ParameterSection start; ///< what is chosen before the metal is made
    ParameterSection view;
    ParameterSection surface;
    ParameterSection simulation;

    std::vector<ParameterSection*> all() { return {&start, &view, &surface, &simulation}; }
    void restoreDefaults();
};

/// The lesson of a catalogue name or TOML file. Throws InputError when it cannot be used.
Lesson loadLesson(const std::string& name);

/// A torch that the mouse does not lead: answers the sample for step `step` (from 0) of the `steps` of a frame.
using TorchSource = std::function<TorchSample(int step, int steps)>;

class LessonSession {
  public:
    /// Throws InputError when the shaders cannot be used.
    LessonSession(gl::ShaderLibrary& shaders, Lesson lesson);
    LessonSession(const LessonSession&) = delete;
    LessonSession& operator=(const LessonSession&) = delete;

    /// Makes the metal from the start values. Throws InputError or RuntimeFault when memory or driver do not suffice.
    void begin(Controls& controls);
    /// Puts metal and source back to their start.
    void reset(Controls& controls);
    /// Ends the lesson and frees the metal.
    void end() {
        trainer_.reset();
        surfaceDistance_ = {};
    }
    bool running() const { return trainer_ != nullptr; }

    /// Runs the steps that fit into `seconds` of real time. The torch follows `held`, or the controls where that is
    /// empty; then nothing runs in view mode.
    void advance(const Controls& controls, double seconds, gl::Profiler* profiler, const TorchSource& held = {});
    /// `shift`: how far right of the window's middle the picture's middle is, as a share of half its width.
    void draw(const Controls& controls, glm::ivec2 pixels, float shift, gl::Profiler* profiler);

    /// Asks where the metal lies under the torch in the hand. The answer comes frames later; nothing waits for it.
    void sound(const TorchSample& torch);
    /// The newest answer; no metal anywhere before the first.
    const SurfaceDistance& surfaceDistance() const { return surfaceDistance_; }
    /// The arc of the last step; out without a running lesson.
    ArcState arc() const { return running() ? trainer_->arc() : ArcState{}; }
    /// Radius (m) of what touches the metal first.
    float touchRadius() const { return running() ? trainer_->touchRadius() : 0; }

    /// The scene with the current surface; empty without a running lesson.
    SceneView scene(gl::Profiler* profiler);
    Renderer& renderer() { return renderer_; }
    /// Metres of a unit of the scene's world, and the lowest place of the workpiece in its own frame, m.
    float unit() const;
    float bottom() const;
    /// From the next start on, and from now on where a lesson runs, every step is written to `file`.
    void record(const std::filesystem::path& file);

    /// The torch of the last steps came from `held`, not from the controls.
    bool held() const { return held_; }

    /// The fault that stopped the simulation; empty while it runs.
    const std::string& fault() const { return fault_; }
    void fillFigures(LessonFigures& figures) const;
    /// The torch of the last step. Only while running().
    const TorchSample& torch() const { return trainer_->torch(); }
    /// What the metal's temperature numbers mean. Only while running().
    TemperatureMeaning temperature() const { return trainer_->scene().temperature; }
    size_t steps() const { return trainer_ == nullptr ? 0 : trainer_->steps(); }
    const Lesson& lesson() const { return lesson_; }
    LessonSections& sections() { return sections_; }

  private:
    bool takeOverChanges(const Controls& controls);

    gl::ShaderLibrary& shaders_;
    Lesson lesson_;
    LessonSections sections_;
    SurfaceParameters shownSurface_;
    Renderer renderer_;
    std::unique_ptr<Trainer> trainer_;
    StepClock clock_;
    std::string fault_;
    bool surfaceIsOld_ = true;
    SurfaceDistance surfaceDistance_;
    bool held_ = false; ///< the torch of the last step came from a TorchSource
    std::filesystem::path record_;
};

} // namespace meltpool
