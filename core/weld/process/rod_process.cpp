#include "core/weld/process/rod_process.hpp"

#include "core/gl/state_archive.hpp"

namespace meltpool {

namespace {

constexpr float kDripSpeed = 0.1F; // m/s at which filler leaves the rod; no source: chosen

} // namespace

void RodProcess::setRod(double diameter) {
    held_ = diameter > 0;
    if (held_) rod_.setDiameter(diameter);
}

const RodSample* RodProcess::heldRod(const TorchSample& torch) const {
    return torch.rod && held_ ? &*torch.rod : nullptr;
}

bool RodProcess::rodTouches(const TorchSample& torch, double electrodeDiameter) const {
    const RodSample* rod = heldRod(torch);
    return rod != nullptr && rod_.touches(*rod, ray(torch), electrodeDiameter);
}

std::optional<TorchRay> RodProcess::rodRay(const TorchSample& torch) const {
    const RodSample* rod = heldRod(torch);
    return rod != nullptr ? std::optional(rod_.ray(*rod)) : std::nullopt;
}

WireAccount RodProcess::wire() const {
    if (rod_.melted() <= 0) return {};
    return {rod_.melted(), rod_.melted(), 0, rod_.area(), metal_.density};
}

void RodProcess::reset() {
    Process::reset();
    rod_.reset();
}

void RodProcess::transfer(gl::StateArchive& archive) {
    Process::transfer(archive);
    rod_.transfer(archive);
}

double RodProcess::meltRod(const TorchSample& torch, const RodArc* heat, double seconds) {
    const RodSample* rod = heldRod(torch);
    if (rod == nullptr) return 0;
    const RodMelt melt = rod_.step(*rod, rodAhead_, heat, metal_, seconds);
    if (melt.volume > 0) dropFiller(melt.volume, melt.place, torch.axis() * kDripSpeed, melt.temperature);
    arc_.rodEaten = static_cast<float>(rod_.eaten());
    arc_.rodBall = static_cast<float>(rod_.ballDiameter());
    arc_.rodInPool = rod_.inPool();
    return melt.heat;
}

} // namespace meltpool
