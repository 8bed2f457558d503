// The lattice layers that one cut takes, and the measures on them.
#pragma once

#include "core/weld/gauge/section_slice.hpp"
#include "core/weld/gauge/weld_particles.hpp"
#include "core/weld/gauge/weld_section.hpp"

namespace meltpool {

class CutLayers {
  public:
    CutLayers(const WeldParticles& particles, const SectionCut& cut);

    SectionMap draw() const;
    /// Measures the section. `map`: the result of draw().
    Section measure(const SectionMap& map) const;

  private:
    struct Layer {
        SectionSlice slice;
        size_t had;                    ///< number of cells that held metal at the start
        size_t holds;                  ///< number of particles there now
        std::vector<int> columns = {}; ///< number of particles there now by column
    };

    /// Returns the number of the layer that contains a place; nothing outside the cut, or for a layer without
    /// workpiece.
    std::optional<size_t> layerOf(const vec4& position) const;
    double rowHeight(int row) const { return static_cast<double>(lattice_.low.y) + row * spacing_; }
    double columnPlace(double column) const { return static_cast<double>(lattice_.low.z) + column * spacing_; }
    void enterOriginal();
    void enterPeaks(const std::vector<size_t>& slots);
    void enterMeanPeaks(const std::vector<size_t>& slots);
    bool melted(size_t slot) const;
    size_t layerOf(glm::ivec3 cell) const { return static_cast<size_t>((cell.x - first_) / perLayer_); }
    void enterPresent();
    int used() const;
    int latticeLayers() const { return used() * perLayer_; }
    /// Returns the mean of `value(layer)` over the layers in use.
    template <class Value>
    double mean(Value value) const;

    WeldZone zoneOf(double kelvin) const;
    void measureShape(const SectionMap& map, Section& section) const;
    void measureLevel(const WeldOutline& outline, Section& section) const;
    /// Returns the height (m) of the upright plate over its corner with the base plate.
    double uprightHeight(glm::ivec2 corner) const;
    void measureCorner(const WeldOutline& outline, glm::ivec2 corner, Section& section) const;
    void measureSeamEdges(Section& section) const;
    std::optional<FaceStretch> meanFusedTop() const;
    double widestHole() const;
    std::optional<double> coolingTime() const;

    const WeldParticles& particles_;
    SectionCut cut_;
    const MetalLattice& lattice_;
    double spacing_;
    int first_ = 0;
    /// Number of lattice layers that are measured as one: all of a rolled-out pipe's, whose cells only together hold
    /// metal wherever the pipe did.
    int perLayer_ = 1;
    std::vector<Layer> layers_;
    std::vector<size_t> living_; ///< slots of the living particles in the layers, ascending
    std::optional<int> level_;   ///< uppermost row of the workpiece if all columns agree on it
    int bottom_ = 0;             ///< lowest row of the workpiece
};

} // namespace meltpool
