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

/// Which process, and the settings of each: those of the others wait for their turn.
struct ProcessSettings {
    int kind = 1; ///< place in AllProcesses
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

/// Constants of the chosen process. They outlive the settings.
const ProcessTraits& traitsOf(const ProcessSettings& settings);
/// Torch, consumables and machine of the chosen process as it is set.
Equipment equipmentOf(const ProcessSettings& settings);

/// Welds with an arc.
inline bool isArcWelding(const ProcessSettings& settings) {
    return traitsOf(settings).arc;
}

/// Diameter (m) of the filler rod or wire in the other hand, which this process melts; 0: none is held.
inline double rodDiameter(const ProcessSettings& settings) {
    return equipmentOf(settings).rod;
}
inline bool holdsRod(const ProcessSettings& settings) {
    return rodDiameter(settings) > 0;
}

/// m from the place that a torch's sample names, along the torch, back to what it is held by its distance from: the
/// contact tip of GMAW. 0 where both are one.
inline double heldBehind(const ProcessSettings& settings) {
    return equipmentOf(settings).heldBehind;
}

/// The name that lessons and records give this process today; `name` may be one of an earlier edition.
std::string_view presentProcessName(std::string_view name);

/// The choice of process, and the settings of the one that is chosen.
ParameterList describe(ProcessSettings& settings);

/// The process that the settings choose, with its settings applied.
std::unique_ptr<Process> makeProcess(const ProcessSettings& settings, const ProcessMetal& metal);

/// What has taken the place of a setting that this process had once; empty where it never had it. A sentence's end,
/// such as "the current follows from voltage and wire_feed_m_min".
std::string_view successorOf(const ProcessSettings& settings, std::string_view key);

} // namespace meltpool
