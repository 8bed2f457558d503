// The welding processes that lessons can name. A new one is a class in a file of its own and one line in
// `AllProcesses`.
#pragma once

#include "core/weld/process/flame.hpp"
#include "core/weld/process/gmaw.hpp"
#include "core/weld/process/gtaw.hpp"
#include "core/weld/process/process_traits.hpp"
#include "core/weld/process/smaw.hpp"
#include "core/weld/process/soldering_iron.hpp"

#include <memory>
#include <tuple>

namespace meltpool {

template <class... P>
struct ProcessList {
    using Settings = std::tuple<typename P::Settings...>;
    static constexpr std::array<std::string_view, sizeof...(P)> kNames{P::kName...};
    static constexpr size_t kCount = sizeof...(P);
};

using AllProcesses = ProcessList<Flame,         //
                                 Gtaw,          //
                                 Gmaw,          //
                                 SolderingIron, //
                                 Smaw>;

/// The chosen process, and the settings of each: those of the others are unused until they are chosen.
struct ProcessSettings {
    int kind = 1; ///< index in AllProcesses
    AllProcesses::Settings each;

    template <class P>
    typename P::Settings& of() {
        return std::get<typename P::Settings>(each);
    }
    template <class P>
    const typename P::Settings& of() const {
        return std::get<typename P::Settings>(each);
    }
    template <class P>
    bool is() const {
        return AllProcesses::kNames[static_cast<size_t>(kind)] == P::kName;
    }
    /// Chooses the process.
    template <class P>
    typename P::Settings& choose() {
        for (size_t i = 0; i < AllProcesses::kCount; ++i)
            if (AllProcesses::kNames[i] == P::kName) kind = static_cast<int>(i);
        return of<P>();
    }
};

/// Returns the constants of the chosen process. They outlive the settings.
const ProcessTraits& traitsOf(const ProcessSettings& settings);
/// Returns torch, consumables and machine of the chosen process at these settings.
Equipment equipmentOf(const ProcessSettings& settings);

/// Returns true for welding with an arc.
inline bool isArcWelding(const ProcessSettings& settings) {
    return traitsOf(settings).arc;
}

/// Returns the diameter (m) of the filler rod or wire in the other hand, which this process melts; 0: none is held.
inline double rodDiameter(const ProcessSettings& settings) {
    return equipmentOf(settings).rod;
}
inline bool holdsRod(const ProcessSettings& settings) {
    return rodDiameter(settings) > 0;
}

/// Returns the distance (m) from the place of a torch's sample, along the torch, back to the point from which its
/// distance is measured: the contact tip of GMAW. 0 if both are one.
inline double heldBehind(const ProcessSettings& settings) {
    return equipmentOf(settings).heldBehind;
}

/// Returns the present name of this process in lessons and records; `name` may be one of an earlier edition.
std::string_view presentProcessName(std::string_view name);

/// Describes the choice of process, and the settings of the chosen one.
ParameterList describe(ProcessSettings& settings);

/// Makes the process that the settings choose, with its settings applied.
std::unique_ptr<Process> makeProcess(const ProcessSettings& settings, const ProcessMetal& metal);

/// Returns the replacement of a setting that this process had in an earlier edition; empty if it never had it. The end
/// of a sentence, such as "the current follows from voltage and wire_feed_m_min".
std::string_view successorOf(const ProcessSettings& settings, std::string_view key);

} // namespace meltpool
