#include "app/session/cut_stand.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <limits>

namespace meltpool {

namespace {

constexpr float kReadable = 0.12f;                   ///< m in the room across the measures, for them to be readable
constexpr float kClear = 0.01f;                      ///< m over the table
constexpr glm::vec3 kToReader(0.0f, 0.28f, 0.96f);   ///< unit vector from the section to the viewer's eyes
constexpr glm::vec3 kReadersUp(0.0f, 0.96f, -0.28f); ///< up in the viewer's picture, square to kToReader

/// Height of the box's lowest corner, m.
float lowestOf(const glm::mat4& modelToRoom, const CutFace& face) {
    float lowest = std::numeric_limits<float>::max();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place((corner & 1) != 0 ? face.at : face.low.x, // the part beyond the cut is removed
                              (corner & 2) != 0 ? face.high.y : face.low.y,
                              (corner & 4) != 0 ? face.high.z : face.low.z);
        lowest = std::min(lowest, (modelToRoom * glm::vec4(place, 1)).y);
    }
    return lowest;
}

} // namespace

glm::mat4 standOfCut(const glm::mat4& modelToRoom, const CutFace& face, float table) {
    const float scale = glm::length(glm::vec3(modelToRoom[0]));
    const float larger = std::max(kReadable / std::max(face.extent * scale, 1e-6f), 1.0f);
    const glm::vec3 up(0, face.up.y, face.up.x), out(1, 0, 0);
    const glm::mat3 fromModel(out, up, glm::cross(out, up)),
        toRoom(kToReader, kReadersUp, glm::cross(kToReader, kReadersUp));
    const glm::mat3 turn = toRoom * glm::transpose(fromModel);
    const glm::vec3 middle(modelToRoom * glm::vec4(face.at, 0, 0, 1));
    glm::mat4 stand = glm::translate(glm::mat4(1), middle) * glm::mat4(turn);
    stand = glm::scale(stand, glm::vec3(scale * larger));
    stand = glm::translate(stand, glm::vec3(-face.at, 0, 0));
    const float lift = table + kClear - lowestOf(stand, face);
    return glm::translate(glm::mat4(1), glm::vec3(0, std::max(lift, 0.0f), 0)) * stand;
}

} // namespace meltpool
