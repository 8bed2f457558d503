// Traits of a process: all properties that other code needs, so that it need not ask which process it is. Each process
// fills in its own in its own file; traitsOf() and equipmentOf() return those of the chosen one.
#pragma once

#include "core/weld/process/ripples.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace meltpool {

struct ShieldingGas;

/// Distance that the hand controls and the score judges, TechniqueQuantity::distance. ctwd: ArcState::distance, of wire
/// processes from the contact tip to the work (of flame and iron from the tip). arcLength: ArcState::length, of
/// processes with an electrode in the torch.
enum class DistanceKind { ctwd, arcLength };

/// Start of an arc.
enum class Striking {
    none,  ///< there is no arc
    spark, ///< a spark jumps to the metal
    wire,  ///< start by itself when the wire reaches the metal
    touch, ///< start when the electrode touches and is lifted
};

/// Cover of the pool against the air.
enum class Shielding {
    none,
    gas,  ///< gas from the torch's nozzle
    slag, ///< slag and gas from the electrode's covering
};

/// The tool in the hand. core/scene draws a model and fittings for each.
enum class TorchShape { wireTorch, tungstenTorch, electrodeHolder, burner, iron };

/// Sound of a process. Levels are root mean squares of full scale, see SoundLevels; they are chosen.
struct ProcessSound {
    float quiet = 0, loud = 0;         ///< noise of the open arc, at the length of the set values and when it goes out
    float lowPitch = 0, highPitch = 0; ///< Hz, middle of its band at these lengths
    bool crackles = false;             ///< true if the electrode's covering pops
    bool scratches = false;            ///< true if the electrode is drawn over the metal before it strikes
    float roar = 0;                    ///< level of a flame, the trigger pulled through
    double postFlow = 0;               ///< s of gas flow after the arc, at least
    double postFlowPerAmpere = 0;      ///< s/A
};

/// A setting that a process had in lessons of earlier editions.
struct RetiredSetting {
    std::string_view key;
    std::string_view successor; ///< end of a sentence, such as "the current follows from voltage and wire_feed_m_min"
};
inline constexpr RetiredSetting kRetiredEfficiency{"efficiency", "the efficiency is a constant of the process"};
inline constexpr RetiredSetting kRetiredSigma{"sigma_mm",
                                              "the width of the heat follows from the arc's length and current"};

/// Constants of a process.
struct ProcessTraits {
    std::string_view name{};       ///< name in lessons, records and results
    std::string_view formerName{}; ///< name in lessons of earlier editions; empty: it had none
    /// True if current flows: light that needs a visor, heat input, estimated imperfections.
    bool arc = false;
    bool feedsWire = false; ///< wire comes through the torch, on a machine that holds the voltage
    DistanceKind distance = DistanceKind::ctwd;
    Striking striking = Striking::none;
    Shielding shielding = Shielding::none;
    TorchShape torch = TorchShape::burner;
    /// EN 1011-1's factor for the heat input of procedure sheets, on which the simulated heat does not depend; none:
    /// the process is not in its table.
    std::optional<double> efficiency{};
    float alternating = 0; ///< Hz of the alternating current for metals that need it, see Material; 0: direct current
    /// Share of light that a metre of the fume scatters: its mass in the air about the arc (some tenths of a gram a
    /// cubic metre for a wire, more for a covered electrode, from fume rates of 0.2 to 0.8 g/min) times about 3 m²/g.
    /// No source gives it so near the arc.
    float fume = 0;
    bool oxideIslands = false; ///< true if silicon and manganese of the filler float as oxide on a pool of steel
    ProcessSound sound{};
    std::span<const RetiredSetting> retired{};
};

/// A setting on the machine's front. Without a unit: nothing is shown.
struct MachineDisplay {
    float value = 0;
    std::string_view unit{}; ///< unit in small letters
    int digits = 0;          ///< digits after the point

    bool operator==(const MachineDisplay&) const = default;
};

/// Torch, consumables and machine at these settings.
struct Equipment {
    double rod = 0;             ///< m, diameter of the filler rod or wire in the other hand; 0: none is held
    double wire = 0;            ///< m, diameter of the wire that the torch feeds; 0: none
    double wireSpeed = 0;       ///< m/s of this wire
    double electrode = 0;       ///< m, core diameter of a covered electrode; 0: none
    std::string_view electrodeName{}; ///< its classification in lessons, such as "e7018"; empty: none
    double electrodeLength = 0; ///< m, length of a new one
    double heldBehind = 0;      ///< m, see heldBehind()
    /// 1/s, drops that an open arc throws; 0: the process throws none. No source gives numbers of drops; all are chosen
    /// by the look of films of such arcs.
    double spatter = 0;
    bool controlledShorts = false; ///< the machine ends each short circuit of the wire without spatter
    FreezingRipples ripples{};
    std::array<MachineDisplay, 2> displays{};
    const ShieldingGas* gas = nullptr; ///< gas from the torch's nozzle; null: the process has none
    double gasFlow = 0;                ///< L/min, set on the machine; 0 also where the machine has no such setting

    /// Returns the volume of wire fed, m³/s.
    double wireRate() const;
    /// Returns true if the pool has no gas at all: none is connected, or none flows.
    bool withoutGas() const;
};

} // namespace meltpool
