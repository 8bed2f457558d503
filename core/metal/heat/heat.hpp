// Heat in the metal on the GPU: conduction, surface loss and sources, in steps that follow the conduction limit.
#pragma once

#include "core/gl/buffer.hpp"
#include "core/gl/buffer_view.hpp"
#include "core/gl/profiler.hpp"
#include "core/gl/program.hpp"
#include "core/metal/state/metal_state.hpp"
#include "shaders/shared/dispatch.h"
#include "shaders/shared/heat.h"

#include <glm/vec3.hpp>

#include <vector>

namespace meltpool {

/// Something that heats metal. The factories state what each needs; power in W goes in exactly, whatever metal is
/// there, and not at all where there is none.
struct HeatSource {
    int kind = SOURCE_SPHERE;
    glm::vec3 place{0};
    glm::vec3 axis{0, -1, 0}; ///< unit vector into the metal
    glm::vec3 ahead{1, 0, 0}; ///< unit vector of travel
    float power = 0;          ///< W
    float size = 0;           ///< radius, sigma or front half-axis, m
    glm::vec4 shape{0};       ///< see HeatSourceData

    /// Volume source 1 - d²/R² of the classic model.
    static HeatSource sphere(glm::vec3 centre, float radius, float power);
    /// Gaussian flux exp(-r²/(2 sigma²)) around `axis`, on surface that faces it.
    static HeatSource gaussian(glm::vec3 place, glm::vec3 axis, float sigma, float power);
    /// Goldak's double ellipsoid. Half-axes in m; the front takes `frontFraction`/2 of the power.
    static HeatSource ellipsoid(glm::vec3 place, glm::vec3 axis, glm::vec3 ahead, float halfWidth, float depth,
                                float front, float rear, float frontFraction, float power);
    /// A tool at `temperature` (K) that touches all surface within `radius`; gives coefficient (W/(m² K)) times area
    /// times difference, and never more than `power`.
    static HeatSource hotTip(glm::vec3 place, float radius, float temperature, float coefficient, float power);

    /// Distance from `place` beyond which the source gives nothing that counts, m.
    float reach() const;
};

/// The surroundings and the method.
struct HeatSettings {
    double ambient = 293.15;     ///< K
    double tableHeight = 0;      ///< m, y of the table that fallen metal lies on
    double tableConductance = 0; ///< W/(m² K) from metal that lies on the table, at ambient temperature; 0: none
    double convection = 0;       ///< W/(m² K); 0 together with `radiation` false: insulated
    bool radiation = false;      ///< with the material's emissivity at the liquidus
    bool evaporation = false;    ///< where the material says how
    double stepShare = 0.15; ///< longest step as a share of dx²/alpha: 1/6 is the limit of stability, and near it the
                             ///< errors of space and time cancel
    double wakingKelvin = 0.03; ///< difference between neighbours below which a tile goes to rest
    bool ledger = false;        ///< books every joule in and out, for the balance
    bool meltedLeaves = false;  ///< melted particles leave the lattice (with flow) or stay on it (heat alone)
};

/// Joules since the start, from the ledger.
struct HeatBalance {
    double gained = 0; ///< from sources and held walls
    double lost = 0;   ///< through the surface
};

/// The solver's list of the slots of all living metal off the lattice (liquid, solid that fell or was fed), except
/// what is held, for passes that run over it. `slots` holds one uint each from entry `first` on, in no particular
/// order. Their number is a uint at byte `count` of `control` and stays on the GPU. Bind `control` as
/// GL_DISPATCH_INDIRECT_BUFFER to dispatch groups of GROUP_SIZE over the list from byte `dispatch`.
/// The list is up to date after HeatSolver::step() as of that step's end, and includes what melted in it. Particles
/// that MetalState::add() brought since and solid that came free since are listed in the next step. A slot stays in the
/// list for good: a pass over it skips those without PHASE_ALIVE.
struct OffLatticeList {
    const gl::Buffer& slots;
    size_t first;
    const gl::Buffer& control; ///< HeatControl
    size_t count;              ///< byte of the number of entries in `control`
    size_t dispatch;           ///< byte of the indirect dispatch arguments in `control`
};

class HeatSolver {
  public:
    /// `state` must outlive the solver.
    HeatSolver(gl::ShaderLibrary& shaders, MetalState& state, const Material& material, const HeatSettings& settings);

    /// Longest step for temperatures up to `hottest` (K): stepShare dx²/alpha, in s.
    double longestStep(double hottest) const;

    /// Makes one step of `seconds`. Reads position, writes heat, phase, position.w; never waits.
    /// Throws RuntimeFault for more than HEAT_SOURCES sources.
    void step(double seconds, std::span<const HeatSource> sources, gl::Profiler* profiler = nullptr);

    /// After particles were added to or taken off the lattice by others: reads it anew and wakes every tile.
    void refresh();

    OffLatticeList offLattice() const;

    /// Tiles that took part in the last step. Waits for the GPU.
    unsigned readActiveTiles() const;
    HeatBalance readBalance() const;

    size_t bytes() const; ///< GPU memory of the solver itself

  private:
    struct Texels {
        gl::BufferView view;
        GLuint unit;
    };

    void makeBuffers();
    void makeTexels();
    void writeTable();
    void prepareBlock();
    void writeBlock(double seconds, std::span<const HeatSource> sources);
    void bind() const;
    void indirect(const gl::Program& program, size_t groups) const;
    void findLoose();
    void listTiles();
    void weighSources();
    void conduct();
    void advance();

    MetalState& state_;
    const Material material_;
    HeatSettings settings_;
    HeatBlock block_{};
    size_t looked_ = 0; ///< slots that were looked at for loose metal
    unsigned regroupings_ = 0;
    double time_ = 0; ///< s
    const gl::Program *refresh_, *collect_, *deposit_, *tiles_, *mean_, *weigh_, *total_, *spread_, *conduct_,
        *advanceLoose_, *advance_;
    gl::Buffer blockBuffer_, table_, cellTheta_, cellWeight_, cellPower_, cellArea_, cellSums_, tileState_, tileStamps_,
        lists_, control_, homes_, partial_, ledger_;
    std::vector<Texels> texels_;
};

} // namespace meltpool
