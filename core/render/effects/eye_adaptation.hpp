// The eye behind the visor: it adapts to bright and dark, and an arc without a filter dazzles it.
#pragma once

#include <glm/vec3.hpp>

namespace meltpool {

/// Light that the eye sees in a frame.
struct EyeScene {
    double arc = 0;              ///< intensity of the arc's light, kPaperLuminance times m²; 0: none
    double height = 0;           ///< m, height of the arc over the metal
    double room = 0;             ///< light of the metal in the workshop's lamps, 1 = white paper
    double passed = 1;           ///< share of all light that the visor lets through
    double drawn = 1;            ///< share of the arc's light that the picture shows
    bool exposed = false;        ///< the eye looks into the arc through too light a filter, or none
    glm::vec3 towards{0, 0, -1}; ///< unit vector to the arc, in the eye's own directions
};

/// Returns the mean light (1 = white paper) of a disc of 30 mm about the pool: steel in the light of an arc of this
/// intensity in a height (m) over its middle. The integral of I cos / (pi d²) over the disc is 2 I (1 - cos a) / (pi
/// R²), with a the angle from the arc's foot to the disc's rim.
double poolLight(double intensity, double height);

/// After-image of an arc in an eye that has looked into it: a dark spot at its place.
struct AfterImage {
    float strength = 0;          ///< strength, 0 none .. 1
    glm::vec3 towards{0, 0, -1}; ///< unit vector in the eye's own directions
};

class EyeAdaptation {
  public:
    /// The picture's mean light that the eye makes of any light: photographers' grey card.
    static constexpr double kGrey = 0.18;
    /// s in which it adapts to more light, and to less: about those of the first, fast part of adaptation.
    static constexpr double kDown = 0.3, kUp = 1.5;
    /// Exposures that it reaches at most: the fast part of adaptation spans about two decades. Its ends are chosen.
    static constexpr double kDarkest = 0.1, kBrightest = 6;
    /// s of looking into an arc that leave nearly the strongest after-image, and in which it fades. No source: chosen.
    static constexpr double kBurnsIn = 0.5, kFades = 4;

    /// Advances the eye. `elapsed`: real s since the last call.
    void update(const EyeScene& scene, double elapsed);

    /// Returns the factor on all light that the eye sees.
    float exposure() const { return static_cast<float>(exposure_); }
    const AfterImage& afterImage() const { return afterImage_; }
    /// Returns the length of the last look into an arc, s; it goes on while exposed() is true.
    double looked() const { return looked_; }
    bool exposed() const { return exposed_; }
    /// Returns the seconds since the last look ended.
    double sinceLook() const { return sinceLook_; }

    /// Returns the exposure that the eye reaches if it goes on seeing this scene.
    static double aim(const EyeScene& scene);

  private:
    double exposure_ = 1;
    bool adapted_ = false; ///< false before the first scene: the eye starts adapted to its first light
    AfterImage afterImage_;
    double looked_ = 0, sinceLook_ = 1e9;
    bool exposed_ = false;
};

} // namespace meltpool
