#include "xr/hidden_triangles.hpp"

#include <algorithm>
#include <atomic>

namespace meltpool::xr {

namespace {

constexpr const char* kExtension = "XR_KHR_visibility_mask";

std::vector<glm::vec2> readMask(const Session& session, PFN_xrGetVisibilityMaskKHR get, uint32_t eye) {
    const auto ask = [&](XrVisibilityMaskKHR& mask) {
        return XR_SUCCEEDED(get(session.handle(), XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, eye,
                                XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask));
    };
    XrVisibilityMaskKHR mask{XR_TYPE_VISIBILITY_MASK_KHR};
    if (!ask(mask) || mask.indexCountOutput == 0) return {};
    std::vector<XrVector2f> vertices(mask.vertexCountOutput);
    std::vector<uint32_t> indices(mask.indexCountOutput);
    mask.vertexCapacityInput = mask.vertexCountOutput;
    mask.indexCapacityInput = mask.indexCountOutput;
    mask.vertices = vertices.data();
    mask.indices = indices.data();
    if (!ask(mask)) return {};
    return writeOut(vertices, indices);
}

} // namespace

std::vector<glm::vec2> writeOut(std::span<const XrVector2f> vertices, std::span<const uint32_t> indices) {
    std::vector<glm::vec2> corners;
    corners.reserve(indices.size());
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::span<const uint32_t> triangle = indices.subspan(i, 3);
        const auto known = [&](uint32_t index) { return index < vertices.size(); };
        if (!std::all_of(triangle.begin(), triangle.end(), known)) continue;
        for (const uint32_t index : triangle)
            corners.emplace_back(vertices[index].x, vertices[index].y);
    }
    return corners;
}

void HiddenMasks::read(const Session& session) {
    static std::atomic<std::uint64_t> last = 0;
    corners_ = {};
    version_ = 0;
    const Instance& instance = session.instance();
    if (!instance.has(kExtension)) return;
    const auto get = instance.function<PFN_xrGetVisibilityMaskKHR>("xrGetVisibilityMaskKHR");
    if (get == nullptr) return;
    for (uint32_t eye = 0; eye < corners_.size(); ++eye)
        corners_[eye] = readMask(session, get, eye);
    if (!corners_[0].empty() || !corners_[1].empty()) version_ = ++last;
}

} // namespace meltpool::xr
