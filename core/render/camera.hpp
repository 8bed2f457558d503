// The two cameras of the desktop: flying freely while looking, orbiting the work while working.
#pragma once

#include "core/render/view.hpp"

#include <glm/vec2.hpp>

namespace meltpool {

/// Pitch and elevation stay inside ±(90° - this), rad, so that the camera never turns upside down.
constexpr float kPoleMargin = 0.01f;

/// View mode: the mouse turns the camera, keys move it. It never rolls.
class FreeCamera {
  public:
    FreeCamera() = default;
    /// Places the camera at `position`, looking at `target`.
    FreeCamera(const glm::vec3& position, const glm::vec3& target);

    /// Turns right by `turn.x` and up by `turn.y`, rad.
    void look(const glm::vec2& turn);
    /// Moves by `way` world units: x to the right, y along the world's up, z forward in the camera's direction.
    void move(const glm::vec3& way);

    const glm::vec3& position() const { return position_; }
    float yaw() const { return yaw_; }     ///< rad, 0 looks along -Z, positive turns left
    float pitch() const { return pitch_; } ///< rad, positive looks up
    glm::quat orientation() const;
    glm::vec3 forward() const;
    glm::vec3 right() const;
    View view(const Lens& lens, float aspect) const;

  private:
    glm::vec3 position_{0.0f, 0.0f, 3.0f};
    float yaw_ = 0;
    float pitch_ = 0;
};

/// Interact mode: looks at a point, the origin at first, from a sphere around it.
class OrbitCamera {
  public:
    OrbitCamera() = default;
    /// azimuth: rad around +Y, 0 is on +Z, positive towards +X; elevation: rad above the xz plane.
    OrbitCamera(float azimuth, float elevation, float distance, const glm::vec3& target = glm::vec3(0.0f));

    /// Orbits by `turn.x` (towards +X from +Z) and over by `turn.y`, rad.
    void orbit(const glm::vec2& turn);
    /// Multiplies the distance; stays inside kNearest..kFarthest.
    void approach(float factor);

    static constexpr float kNearest = 0.3f;
    static constexpr float kFarthest = 20.0f;

    float azimuth() const { return azimuth_; }
    float elevation() const { return elevation_; }
    float distance() const { return distance_; }
    const glm::vec3& target() const { return target_; }
    glm::vec3 position() const;
    glm::quat orientation() const;
    glm::vec3 forward() const;
    glm::vec3 right() const;
    View view(const Lens& lens, float aspect) const;
    bool operator==(const OrbitCamera&) const = default;

  private:
    float azimuth_ = 0.7f;
    float elevation_ = 0.45f;
    float distance_ = 3.2f;
    glm::vec3 target_{0.0f};
};

} // namespace meltpool
