#include "core/weld/process/processes.hpp"

namespace meltpool {

namespace {

struct RetiredKey {
    std::string_view process, key, successor;
};

constexpr std::string_view kEfficiency = "the efficiency is a constant of the process";
constexpr std::string_view kSigma = "the width of the heat follows from the arc's length and current";
constexpr std::string_view kArcLength = "the arc's length is the distance of the torch from the metal";
constexpr std::array kRetired{
    RetiredKey{"gtaw", "voltage", "the voltage follows from the arc's length"},
    RetiredKey{"gtaw", "efficiency", kEfficiency},
    RetiredKey{"gtaw", "sigma_mm", kSigma},
    RetiredKey{"gtaw", "arc_length_mm", kArcLength},
    RetiredKey{"gmaw", "current", "the current follows from voltage and wire_feed_m_min"},
    RetiredKey{"gmaw", "efficiency", kEfficiency},
    RetiredKey{"gmaw", "sigma_mm", kSigma},
    RetiredKey{"gmaw", "arc_length_mm", "the arc's length follows from voltage and wire_feed_m_min"},
    RetiredKey{"gmaw", "drop_temperature_c", "the drops' temperature is a constant of the process"},
    RetiredKey{"gmaw", "drop_speed", "the drops' speed is a constant of the process"},
};

template <class... P>
ParameterList settingsOf(ProcessSettings& settings, ProcessList<P...>) {
    ParameterList list;
    const auto add = [&]<class One>(std::type_identity<One>) {
        if (!settings.is<One>()) return;
        for (Parameter& parameter : describe(settings.of<One>()))
            list.push_back(std::move(parameter));
    };
    (add(std::type_identity<P>{}), ...);
    return list;
}

template <class... P>
std::unique_ptr<Process> make(const ProcessSettings& settings, const ProcessMetal& metal, ProcessList<P...>) {
    std::unique_ptr<Process> made;
    const auto attempt = [&]<class One>(std::type_identity<One>) {
        if (settings.is<One>()) made = std::make_unique<One>(metal);
    };
    (attempt(std::type_identity<P>{}), ...);
    return made;
}

} // namespace

ParameterList describe(ProcessSettings& settings) {
    ParameterList list{{"process", "Process", "", &settings.kind, 0, AllProcesses::kCount - 1, "what the torch is",
                        AllProcesses::kNames, true}};
    for (Parameter& parameter : settingsOf(settings, AllProcesses{}))
        list.push_back(std::move(parameter));
    return list;
}

bool isArcWelding(const ProcessSettings& settings) {
    return settings.is<Gmaw>() || settings.is<Gtaw>() || settings.is<Smaw>();
}

double rodDiameter(const ProcessSettings& settings) {
    if (settings.is<Gtaw>()) return static_cast<double>(settings.of<Gtaw>().rodDiameterMm) * 1e-3;
    if (settings.is<Flame>()) return static_cast<double>(settings.of<Flame>().rodDiameterMm) * 1e-3;
    if (settings.is<SolderingIron>()) return static_cast<double>(settings.of<SolderingIron>().rodDiameterMm) * 1e-3;
    return 0;
}

double heldBehind(const ProcessSettings& settings) {
    return settings.is<Gmaw>() ? static_cast<double>(settings.of<Gmaw>().stickOutMm) * 1e-3 : 0.0;
}

std::unique_ptr<Process> makeProcess(const ProcessSettings& settings, const ProcessMetal& metal) {
    auto made = make(settings, metal, AllProcesses{});
    made->apply(settings);
    return made;
}

std::string_view successorOf(const ProcessSettings& settings, std::string_view key) {
    const std::string_view process = AllProcesses::kNames[static_cast<size_t>(settings.kind)];
    for (const RetiredKey& retired : kRetired)
        if (retired.process == process && retired.key == key) return retired.successor;
    return {};
}

} // namespace meltpool
