// Shows a running lesson: the surface of its metal, the solids around it, and the sparks of the arc. It exists only if
// there are pictures, or a hand that must feel the metal.
#pragma once

#include "core/scene/chalk_line.hpp"
#include "core/scene/joint_marks.hpp"
#include "core/surface/surface.hpp"
#include "core/training/feedback/arc_appearance.hpp"
#include "core/training/judging/welded_places.hpp"
#include "core/training/trainer/tip_probe.hpp"
#include "core/training/trainer/trainer.hpp"

#include <memory>
#include <optional>

namespace meltpool {

class LessonScene : private StepWatcher {
  public:
    /// Makes the surface for the trainer's metal and watches its steps from now on. The trainer must outlive this.
    /// Throws InputError if the lesson's surface is impossible here, RuntimeFault without GPU memory.
    LessonScene(gl::ShaderLibrary& shaders, Trainer& trainer);
    ~LessonScene() override;
    LessonScene(const LessonScene&) = delete;
    LessonScene& operator=(const LessonScene&) = delete;

    /// The trainer of the shown lesson.
    const Trainer& trainer() const { return trainer_; }

    /// Makes the surface of the present metal, for the pictures to come; it reads no data back.
    void updateSurface(gl::Profiler* profiler) {
        noteMetal();
        makeSurface(profiler);
    }
    /// The two parts of updateSurface(): for a metal in another context makeSurface() shows the metal of the last
    /// noteMetal(), while steps are made there. makeSurface() is a no-op without a new noteMetal().
    void noteMetal();
    void makeSurface(gl::Profiler* profiler);
    const Surface& surface() const { return *surface_; }

    /// The world under the trainer's torch, with the surface of the last updateSurface(). Its solids and sparks are
    /// valid until the next call.
    SceneView view();
    /// See MetalScene::addHolders().
    void addHolders(std::vector<Solid>& solids, float overTable) const { around_->addHolders(solids, overTable); }

    /// Requests the metal's place under this torch, on the surface of the last updateSurface(); never waits.
    void requestDistance(const TorchSample& torch);
    /// The answer, once, some frames later.
    std::optional<SurfaceDistance> pollDistance();
    /// Waits for the GPU.
    SurfaceDistance distanceNow(const TorchSample& torch);

  private:
    void stepped() override;
    void beganAgain() override;
    void restored() override;
    SceneView withoutSurface(const TorchSample& torch);
    void forgetOldMetal();
    void drawChalk();
    void markJoint(const TechniqueBands& bands);
    void wipeChalk();

    Trainer& trainer_;
    std::unique_ptr<MetalScene> around_;
    std::unique_ptr<Surface> surface_;
    std::optional<ParticleView> noted_; ///< particles for the surface
    TipProbe probe_;
    bool metalExchanged_ = false; ///< true: the metal was replaced since the probe's request; the scene's thread then
                                  ///< drops the request
    ArcAppearance sight_;
    std::optional<ChalkLine> chalk_; ///< on a plate without a joint
    std::vector<Solid> marks_;       ///< at a joint
    std::optional<WeldedPlaces> welded_;
    size_t wiped_ = 0; ///< WeldedPlaces::changes() of the chalk that is left
};

} // namespace meltpool
