// The lesson on the desktop: what is set at its start and while it runs, and the Trainer that runs it.
#pragma once

#include "app/desktop/controls.hpp"
#include "app/desktop/step_clock.hpp"
#include "app/desktop/ui/panels.hpp"
#include "core/render/renderer.hpp"
#include "core/training/trainer.hpp"

#include <memory>
#include <string>
#include <vector>

namespace meltpool {

/// A lesson's values as the menus group them. They point into the lesson, which must outlive them unmoved; the defaults
/// are what the lesson held when this was made.
struct LessonSections {
    explicit LessonSections(Lesson& lesson);

    ui::Section start; ///< what is chosen before the metal is made
    ui::Section view;
    ui::Section surface;
    ui::Section simulation;

    std::vector<ui::Section*> all() { return {&start, &view, &surface, &simulation}; }
    void restoreDefaults();
};

/// The lesson of a catalogue name or TOML file. Throws InputError when it cannot be used.
Lesson loadLesson(const std::string& name);

class Session {
  public:
    /// Throws InputError when the shaders cannot be used.
    Session(gl::ShaderLibrary& shaders, Lesson lesson);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Makes fresh metal from the start values. Throws InputError or RuntimeFault when the machine cannot hold it.
    void begin(Controls& controls);
    /// Puts metal and source back.
    void reset(Controls& controls);
    /// Gives the metal back.
    void end() { trainer_.reset(); }
    bool running() const { return trainer_ != nullptr; }

    /// Runs the steps that `seconds` of real time ask for, none while the person looks around.
    void advance(const Controls& controls, double seconds, gl::Profiler* profiler);
    /// `shift`: how far right of the window's middle the picture's middle is, as a share of half its width.
    void draw(const Controls& controls, glm::ivec2 pixels, float shift, gl::Profiler* profiler);

    /// The fault that stopped the metal; empty while all is well.
    const std::string& fault() const { return fault_; }
    void fillFigures(ui::Figures& figures) const;
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
};

} // namespace meltpool
