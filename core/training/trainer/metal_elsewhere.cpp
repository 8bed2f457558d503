#include "core/training/trainer/metal_elsewhere.hpp"

#include "core/training/lesson/lesson.hpp"

#include <type_traits>

namespace meltpool {

/// Does it there, and gives what it gives.
template <class Work>
auto MetalElsewhere::run(const Work& work) const {
    using Result = std::invoke_result_t<Work>;
    if constexpr (std::is_void_v<Result>) {
        there_.run(work);
    } else {
        std::optional<Result> result;
        there_.run([&] { result.emplace(work()); });
        return std::move(*result);
    }
}

MetalElsewhere::MetalElsewhere(gl::OtherContext& there, const Lesson& lesson) : there_(there) {
    run([&] { metal_ = makeMetalModel(there_.shaders(), lesson); });
}

MetalElsewhere::~MetalElsewhere() {
    run([this] {
        times_.reset();
        metal_.reset();
    });
}

void MetalElsewhere::reset() {
    changed_ = true;
    run([this] { metal_->reset(); });
}

void MetalElsewhere::apply(const Lesson& lesson) {
    run([&] { metal_->apply(lesson); });
}

void MetalElsewhere::step(const TorchSample& torch, gl::Profiler* profiler) {
    changed_ = true;
    if (profiler == nullptr || !profiler->inFrame()) return run([&] { metal_->step(torch, nullptr); });
    run([&] { stepTimed(torch); });
    profiler->include(*times_);
}

/// Timer queries are of one context.
void MetalElsewhere::stepTimed(const TorchSample& torch) {
    if (!times_) times_.emplace();
    times_->reset();
    times_->beginFrame();
    metal_->step(torch, &*times_);
    times_->endFrame();
    times_->finish();
}

ParticleView MetalElsewhere::particles() const {
    const ParticleView original = metal_->particles();
    if (there_.here()) return original;
    if (changed_) mirror_.take(original, there_);
    changed_ = false;
    return mirror_.view();
}

SceneView MetalElsewhere::scene(const TorchSample& torch) const {
    SceneView scene = metal_->scene(torch);
    scene.particles = particles();
    return scene;
}

std::optional<WeldSection> MetalElsewhere::section(std::optional<double> place) const {
    return run([&] { return metal_->section(place); });
}

std::optional<WeldMeasures> MetalElsewhere::measureWeld(std::optional<FaceStretch> seam) const {
    return run([&] { return metal_->measureWeld(seam); });
}

MetalStatistics MetalElsewhere::statistics() {
    return run([this] { return metal_->statistics(); });
}

void MetalElsewhere::requestStatistics() {
    run([this] { metal_->requestStatistics(); });
}

std::optional<MetalStatistics> MetalElsewhere::pollStatistics() {
    return run([this] { return metal_->pollStatistics(); });
}

std::optional<MetalStatistics> MetalElsewhere::awaitStatistics() {
    return run([this] { return metal_->awaitStatistics(); });
}

void MetalElsewhere::transfer(gl::StateArchive& archive) {
    changed_ |= archive.restores();
    run([&] { metal_->transfer(archive); });
}

void MetalElsewhere::fold() {
    run([this] { metal_->fold(); });
}

std::uint64_t MetalElsewhere::stateHash() const {
    return run([this] { return metal_->stateHash(); });
}

} // namespace meltpool
