#include "core/scene/ghost_model.hpp"

#include "core/scene/torch_model.hpp"

#include <glm/ext/matrix_transform.hpp>

namespace meltpool {

namespace {

/// Returns a transform scaled about a point of the workpiece's frame.
glm::mat4 sized(const glm::mat4& toWorld, const glm::vec3& about, float size) {
    return glm::translate(glm::scale(glm::translate(toWorld, about), glm::vec3(size)), -about);
}

} // namespace

void addGhostTorch(std::vector<Marker>& markers, std::vector<Solid>& parts, const TorchSample& torch,
                   const ProcessSettings& process, const ArcState& arc, float strength, float size,
                   const glm::mat4& workpieceToWorld) {
    const size_t ofRod = buildTorchModel(parts, torch, process, arc, glm::mat4(1.0F));
    const glm::mat4 torchToWorld = sized(workpieceToWorld, torch.tip, size);
    const glm::mat4 rodToWorld = torch.rod ? sized(workpieceToWorld, torch.rod->tip, size) : torchToWorld;
    for (size_t i = 0; i < parts.size(); ++i) {
        const bool rod = i + ofRod >= parts.size();
        markers.push_back({parts[i].shape, (rod ? rodToWorld : torchToWorld) * parts[i].toWorld, kGhostColour,
                           kGhostOpacity * strength, kGhostFace});
    }
}

} // namespace meltpool
