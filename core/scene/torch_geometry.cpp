#include "core/scene/torch_geometry.hpp"

#include "core/render/solid.hpp"

#include <cmath>

namespace meltpool {

glm::vec3 TorchGeometry::tip() const {
    // Both straight parts, prolonged, meet in a corner.
    const float more = bendRadius * std::tan(0.5f * bend);
    const float along = neck + more;
    return {0, -along * std::sin(bend), -(lead + held() + more) - along * std::cos(bend)};
}

glm::quat TorchGeometry::tipOrientation() const {
    return glm::angleAxis(-bend, glm::vec3(1, 0, 0));
}

TorchGeometry torchGeometry(const ProcessSettings& process) {
    const Equipment tools = equipmentOf(process);
    const auto stickOut = static_cast<float>(tools.heldBehind), electrode = static_cast<float>(tools.electrodeLength);
    switch (traitsOf(process).torch) {
    case TorchShape::wireTorch:
        return {stickOut, stickOut + 0.086f, kBendAngle, kBendRadius * 0.0125f, 0.035f, 0.14f, 0.030f};
    case TorchShape::tungstenTorch: // about 70 degrees between head and handle are usual
        return {0.006f, 0.055f, 1.2f, 0, 0.035f, 0.15f, 0.026f};
    case TorchShape::electrodeHolder: // the jaws hold the electrode by its bare end
        return {electrode - 0.012f, electrode - 0.012f, 1.25f, 0, 0.072f, 0.14f, 0.034f};
    case TorchShape::burner:
        return {0.012f, 0.092f, kBendAngle, kBendRadius * 0.0075f, 0.074f, 0.14f, 0.026f};
    case TorchShape::iron:
        return {0.0115f, 0.088f, 0, 0, 0, 0.12f, 0.024f};
    }
    return kPlainTorch;
}

} // namespace meltpool
