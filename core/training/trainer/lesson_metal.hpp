// Holds the metal of a lesson in its context: the calling thread's, or another one whose steps wait for no picture.
#pragma once

#include "core/gl/context_thread.hpp"
#include "core/metal/state/particle_mirror.hpp"
#include "core/training/trainer/metal_model.hpp"

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace meltpool {

/// Rules for metal in another context: each function may be called on that context's thread or, while that thread is
/// idle, on the thread that made this. particles() returns buffers of the calling thread's context: on the latter
/// thread copies, made by the first call after the metal changed, which stay unchanged while further steps are made.
class LessonMetal {
  public:
    /// `there`: the metal's context, null for the calling thread's. It must outlive the metal, and any thread must be
    /// able to read its buffers (gl::directMemory()). Throws as makeMetalModel().
    LessonMetal(gl::ShaderLibrary& shaders, const Lesson& lesson, gl::ContextThread* there);
    ~LessonMetal();
    LessonMetal(const LessonMetal&) = delete;
    LessonMetal& operator=(const LessonMetal&) = delete;

    /// Runs `work`, a function of the MetalModel that leaves its particles unchanged, in the metal's context. Returns
    /// its result, rethrows its exceptions, and allocates nothing.
    template <class Work>
    auto run(const Work& work) const;
    /// Runs a function that changes the particles.
    template <class Work>
    auto change(const Work& work) {
        changed_ = true;
        return run(work);
    }

    /// The model, for queries that need no context: units, arc, wire.
    const MetalModel& model() const { return *metal_; }

    /// One fixed step. `profiler` may be null.
    void step(const TorchSample& torch, gl::Profiler* profiler);
    ParticleView particles() const;
    /// GPU memory including the copies, bytes.
    size_t bytes() const { return metal_->bytes() + mirror_.bytes(); }

  private:
    void stepTimed(const TorchSample& torch);

    gl::ContextThread* there_;
    std::unique_ptr<MetalModel> metal_;
    std::optional<gl::Profiler> times_; ///< profiler of the other context: timer queries belong to one context
    mutable ParticleMirror mirror_;
    mutable bool changed_ = true; ///< since the mirror was made
};

template <class Work>
auto LessonMetal::run(const Work& work) const {
    using Result = std::invoke_result_t<Work, MetalModel&>;
    if (there_ == nullptr) return work(*metal_);
    if constexpr (std::is_void_v<Result>) {
        there_->run([&] { work(*metal_); });
    } else {
        std::optional<Result> result;
        there_->run([&] { result.emplace(work(*metal_)); });
        return Result(std::move(*result));
    }
}

} // namespace meltpool
