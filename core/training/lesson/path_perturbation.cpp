#include "core/training/lesson/path_perturbation.hpp"

namespace meltpool {

PerturbedPath::PerturbedPath(const TorchPath& path, const Seam& seam, const PathPerturbation& bend)
    : path_(path), seam_(seam), bend_(bend), tremor_(bend.tremor) {}

TorchSample PerturbedPath::sample(double time) const {
    TorchSample torch = path_.sample(time / bend_.time);
    torch.time = time;
    torch.tip -= torch.axis() * static_cast<float>(bend_.farther);
    const SeamFrame frame = seam_.at(seam_.nearest(torch.tip).place);
    // A right-handed turn about the tangent turns `up` towards `across`, which is tangent x up.
    const glm::quat turn = glm::angleAxis(static_cast<float>(bend_.turn), glm::vec3(frame.tangent));
    const glm::vec3 point(frame.point);
    torch.tip = point + turn * (torch.tip - point) + static_cast<float>(bend_.aside) * glm::vec3(frame.across);
    torch.orientation = turn * torch.orientation;
    if (bend_.tremor != 0) tremor_.shake(torch, time, bend_.tremorPlace, bend_.tremorAngle);
    return torch;
}

} // namespace meltpool
