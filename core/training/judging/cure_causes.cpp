#include "core/training/judging/cure_causes.hpp"

#include <array>

namespace meltpool {

namespace {

using enum TechniqueQuantity;
using enum CureEffect;

constexpr int kMore = 1, kLess = -1, kEither = 0;

constexpr bool feedsWire(const ProcessTraits& traits) {
    return traits.feedsWire;
}

/// A covered electrode, which melts.
constexpr bool meltsElectrode(const ProcessTraits& traits) {
    return traits.shielding == Shielding::slag;
}

/// An electrode of tungsten.
constexpr bool keepsElectrode(const ProcessTraits& traits) {
    return traits.arc && !feedsWire(traits) && !meltsElectrode(traits);
}

using Only = bool (*)(const ProcessTraits&);

constexpr CureCause hand(std::string_view imperfection, TechniqueQuantity quantity, int sign, CureEffect effect,
                         Only only = nullptr) {
    return {imperfection, quantity, {}, sign, effect, only};
}

constexpr CureCause set(std::string_view imperfection, std::string_view key, int sign, CureEffect effect,
                        Only only = nullptr) {
    return {imperfection, {}, key, sign, effect, only};
}

/// Rules of the trade, from no single source. Current and wire feed are one knob of a wire machine: more wire takes
/// more current, melts deeper and fills more. Voltage spreads the arc and wets the toes.
constexpr std::array kCauses{
    hand("lack_of_fusion", travelSpeed, kMore, cold),
    hand("lack_of_fusion", travelSpeed, kLess, runsAhead),
    hand("lack_of_fusion", aim, kEither, oneSided),
    hand("lack_of_fusion", workAngle, kEither, oneSided),
    hand("lack_of_fusion", distance, kMore, cold),
    hand("lack_of_fusion", travelAngle, kMore, runsAhead),
    hand("lack_of_fusion", weaveWidth, kMore, cold),
    hand("lack_of_fusion", rodFrequency, kMore, muchMetal),
    set("lack_of_fusion", "current", kLess, cold),
    set("lack_of_fusion", "wire_feed_m_min", kLess, cold),
    set("lack_of_fusion", "voltage", kLess, cold),
    set("lack_of_fusion", "flame_power", kLess, cold),
    set("lack_of_fusion", "tip_temperature_c", kLess, cold),
    set("lack_of_fusion", "thickness_mm", kMore, cold),

    hand("burn_through", travelSpeed, kLess, hot),
    hand("burn_through", distance, kLess, hot),
    hand("burn_through", travelAngle, kLess, hot),
    hand("burn_through", rodFrequency, kLess, hot),
    hand("burn_through", weaveDwell, kMore, hot),
    hand("burn_through", whipDwell, kMore, hot),
    set("burn_through", "current", kMore, hot),
    set("burn_through", "wire_feed_m_min", kMore, hot),
    set("burn_through", "voltage", kMore, hot),
    set("burn_through", "flame_power", kMore, hot),
    set("burn_through", "tip_temperature_c", kMore, hot),
    set("burn_through", "gap_mm", kMore, setUp),
    set("burn_through", "thickness_mm", kLess, hot),

    hand("root_penetration_missing", travelSpeed, kMore, cold),
    hand("root_penetration_missing", aim, kEither, oneSided),
    hand("root_penetration_missing", distance, kMore, cold),
    hand("root_penetration_missing", travelSpeed, kLess, runsAhead),
    hand("root_penetration_missing", travelAngle, kMore, runsAhead),
    hand("root_penetration_missing", weaveWidth, kMore, cold),
    hand("root_penetration_missing", rodFrequency, kMore, muchMetal),
    set("root_penetration_missing", "current", kLess, cold),
    set("root_penetration_missing", "wire_feed_m_min", kLess, cold),
    set("root_penetration_missing", "voltage", kLess, cold),
    set("root_penetration_missing", "flame_power", kLess, cold),
    set("root_penetration_missing", "gap_mm", kLess, setUp),
    set("root_penetration_missing", "thickness_mm", kMore, cold),

    hand("undercut", travelSpeed, kMore, starved),
    hand("undercut", distance, kMore, starved, meltsElectrode),
    hand("undercut", distance, kMore, starved, keepsElectrode),
    hand("undercut", workAngle, kEither, oneSided),
    hand("undercut", aim, kEither, oneSided),
    hand("undercut", weaveDwell, kLess, starved),
    hand("undercut", weaveFrequency, kMore, starved),
    hand("undercut", rodFrequency, kLess, starved),
    set("undercut", "voltage", kMore, hot),
    set("undercut", "current", kMore, hot),
    set("undercut", "wire_feed_m_min", kMore, hot),
    set("undercut", "flame_power", kMore, hot),

    hand("excess_weld_metal", travelSpeed, kLess, muchMetal),
    hand("excess_weld_metal", rodFrequency, kMore, muchMetal),
    hand("excess_weld_metal", distance, kMore, cold, feedsWire),
    hand("excess_weld_metal", weaveWidth, kLess, muchMetal),
    set("excess_weld_metal", "wire_feed_m_min", kMore, muchMetal),
    set("excess_weld_metal", "voltage", kLess, cold),
    set("excess_weld_metal", "current", kMore, muchMetal, meltsElectrode),
    set("excess_weld_metal", "current", kLess, cold, keepsElectrode),
    set("excess_weld_metal", "flame_power", kLess, cold),
    set("excess_weld_metal", "gap_mm", kLess, setUp),

    hand("convexity", travelSpeed, kLess, muchMetal),
    hand("convexity", distance, kMore, cold, feedsWire),
    hand("convexity", rodFrequency, kMore, muchMetal),
    hand("convexity", weaveWidth, kLess, muchMetal),
    hand("convexity", travelAngle, kLess, muchMetal),
    set("convexity", "voltage", kLess, cold),
    set("convexity", "wire_feed_m_min", kMore, muchMetal),
    set("convexity", "current", kLess, cold),
    set("convexity", "flame_power", kLess, cold),
    set("convexity", "tip_temperature_c", kLess, cold),

    hand("excess_penetration", travelSpeed, kLess, hot),
    hand("excess_penetration", distance, kLess, hot),
    hand("excess_penetration", travelAngle, kLess, hot),
    hand("excess_penetration", rodFrequency, kLess, hot),
    hand("excess_penetration", whipDwell, kMore, hot),
    set("excess_penetration", "current", kMore, hot),
    set("excess_penetration", "wire_feed_m_min", kMore, hot),
    set("excess_penetration", "voltage", kMore, hot),
    set("excess_penetration", "flame_power", kMore, hot),
    set("excess_penetration", "gap_mm", kMore, setUp),
    set("excess_penetration", "thickness_mm", kLess, hot),

    hand("toe_angle", travelSpeed, kLess, muchMetal),
    hand("toe_angle", distance, kMore, cold, feedsWire),
    hand("toe_angle", rodFrequency, kMore, muchMetal),
    hand("toe_angle", aim, kEither, oneSided),
    hand("toe_angle", workAngle, kEither, oneSided),
    hand("toe_angle", weaveDwell, kLess, cold),
    hand("toe_angle", travelAngle, kLess, muchMetal),
    set("toe_angle", "voltage", kLess, cold),
    set("toe_angle", "wire_feed_m_min", kMore, muchMetal),
    set("toe_angle", "current", kLess, cold),
    set("toe_angle", "flame_power", kLess, cold),
    set("toe_angle", "tip_temperature_c", kLess, cold),

    hand("overlap", travelSpeed, kLess, muchMetal),
    hand("overlap", distance, kMore, cold),
    hand("overlap", aim, kEither, oneSided),
    hand("overlap", workAngle, kEither, oneSided),
    hand("overlap", rodFrequency, kMore, muchMetal),
    hand("overlap", weaveDwell, kLess, cold),
    set("overlap", "voltage", kLess, cold),
    set("overlap", "wire_feed_m_min", kMore, muchMetal),
    set("overlap", "current", kLess, cold),
    set("overlap", "flame_power", kLess, cold),
    set("overlap", "tip_temperature_c", kLess, cold),
    set("overlap", "thickness_mm", kMore, cold),
    // A pool that is too hot sags over the plate below it.
    set("overlap", "voltage", kMore, hot),
    set("overlap", "current", kMore, hot),
    set("overlap", "thickness_mm", kLess, hot),

    hand("excessive_asymmetry", aim, kEither, oneSided),
    hand("excessive_asymmetry", workAngle, kEither, oneSided),
    hand("excessive_asymmetry", travelSpeed, kLess, muchMetal),
    hand("excessive_asymmetry", rodFrequency, kMore, muchMetal),
    set("excessive_asymmetry", "wire_feed_m_min", kMore, muchMetal),
    set("excessive_asymmetry", "current", kMore, hot),
    set("excessive_asymmetry", "voltage", kMore, hot),
    set("excessive_asymmetry", "thickness_mm", kLess, hot),

    hand("incompletely_filled_groove", travelSpeed, kMore, littleMetal),
    hand("incompletely_filled_groove", rodFrequency, kLess, littleMetal),
    hand("incompletely_filled_groove", aim, kEither, oneSided),
    hand("incompletely_filled_groove", weaveDwell, kLess, littleMetal),
    set("incompletely_filled_groove", "wire_feed_m_min", kLess, littleMetal),
    set("incompletely_filled_groove", "current", kLess, littleMetal, meltsElectrode),
    set("incompletely_filled_groove", "current", kMore, hot, keepsElectrode),
    set("incompletely_filled_groove", "voltage", kMore, hot),
    set("incompletely_filled_groove", "gap_mm", kMore, setUp),

    hand("root_concavity", travelSpeed, kLess, hot),
    hand("root_concavity", distance, kMore, littleMetal),
    hand("root_concavity", rodFrequency, kLess, littleMetal),
    set("root_concavity", "current", kMore, hot),
    set("root_concavity", "voltage", kMore, hot),
    set("root_concavity", "wire_feed_m_min", kLess, littleMetal),
    set("root_concavity", "gap_mm", kMore, setUp),

    hand("insufficient_throat", travelSpeed, kMore, littleMetal),
    hand("insufficient_throat", rodFrequency, kLess, littleMetal),
    hand("insufficient_throat", aim, kEither, oneSided),
    hand("insufficient_throat", workAngle, kEither, oneSided),
    hand("insufficient_throat", weaveWidth, kMore, littleMetal),
    set("insufficient_throat", "wire_feed_m_min", kLess, littleMetal),
    set("insufficient_throat", "current", kLess, littleMetal, meltsElectrode),
    set("insufficient_throat", "voltage", kMore, hot),
    set("insufficient_throat", "voltage", kLess, cold), // a convex bead with short legs
    set("insufficient_throat", "gap_mm", kMore, setUp),
    set("insufficient_throat", "thickness_mm", kLess, hot),

    hand("excessive_throat", travelSpeed, kLess, muchMetal),
    hand("excessive_throat", rodFrequency, kMore, muchMetal),
    hand("excessive_throat", weaveWidth, kLess, muchMetal),
    set("excessive_throat", "wire_feed_m_min", kMore, muchMetal),
    set("excessive_throat", "current", kMore, muchMetal, meltsElectrode),
    set("excessive_throat", "voltage", kLess, cold),

    hand("leg_too_small", travelSpeed, kMore, littleMetal),
    hand("leg_too_small", aim, kEither, oneSided),
    hand("leg_too_small", workAngle, kEither, oneSided),
    hand("leg_too_small", rodFrequency, kLess, littleMetal),
    set("leg_too_small", "wire_feed_m_min", kLess, littleMetal),
    set("leg_too_small", "voltage", kLess, cold),
    set("leg_too_small", "current", kLess, littleMetal, meltsElectrode),

    set("joint_gap", "gap_mm", kMore, setUp),

    hand("crack", travelSpeed, kMore, cold),
    hand("crack", weaveWidth, kMore, hot),
    set("crack", "thickness_mm", kMore, cold),
    set("crack", "current", kMore, hot),

    hand("surface_pore", distance, kMore, air),
    hand("surface_pore", travelAngle, kEither, air),
    hand("surface_pore", travelSpeed, kMore, air),
    set("surface_pore", "gas_flow_l_min", kLess, air),
    set("surface_pore", "voltage", kMore, air),
    hand("piping_porosity", distance, kMore, air),
    hand("piping_porosity", travelAngle, kEither, air),
    set("piping_porosity", "gas_flow_l_min", kLess, air),
    set("piping_porosity", "voltage", kMore, air),

    hand("unfilled_crater", travelSpeed, kMore, littleMetal),
    hand("unfilled_crater", rodFrequency, kLess, littleMetal),
    set("unfilled_crater", "current", kMore, hot),
    set("unfilled_crater", "voltage", kMore, hot),

    hand("end_crater_pipe", travelSpeed, kMore, littleMetal),
    hand("end_crater_pipe", rodFrequency, kLess, littleMetal),
    set("end_crater_pipe", "current", kMore, hot),
    set("end_crater_pipe", "voltage", kMore, hot),

    hand("root_groove", travelSpeed, kMore, starved),
    set("root_groove", "current", kMore, hot),
    set("root_groove", "voltage", kMore, hot),
    set("root_groove", "gap_mm", kMore, setUp),

    hand("poor_restart", travelSpeed, kMore, cold),
    hand("poor_restart", distance, kMore, cold),
    set("poor_restart", "current", kLess, cold),

    hand("spatter", distance, kMore, hot),
    hand("spatter", travelAngle, kEither, air),
    set("spatter", "voltage", kMore, hot),
    set("spatter", "current", kMore, hot),

    hand("slag_inclusion", travelAngle, kMore, slag),
    hand("slag_inclusion", travelSpeed, kLess, slag),
    hand("slag_inclusion", distance, kMore, slag),
    set("slag_inclusion", "current", kLess, cold),
};

} // namespace

std::string_view nameOf(CureEffect effect) {
    static constexpr std::array<std::string_view, 10> kNames{
        "cold", "hot", "much_metal", "little_metal", "starved", "one_sided", "runs_ahead", "air", "slag", "set_up"};
    return kNames[static_cast<size_t>(effect)];
}

std::span<const CureCause> cureCauses() {
    return kCauses;
}

} // namespace meltpool
