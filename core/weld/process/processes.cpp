#include "core/weld/process/processes.hpp"

#include "core/weld/process/shielding_gas.hpp"

#include <numbers>

namespace meltpool {

namespace {

template <class... P>
std::span<const ProcessTraits* const> allTraits(ProcessList<P...>) {
    static constexpr std::array<const ProcessTraits*, sizeof...(P)> kAll{&P::kTraits...};
    return kAll;
}

template <class... P>
Equipment equipmentIn(const ProcessSettings& settings, ProcessList<P...>) {
    Equipment made;
    const auto attempt = [&]<class One>(std::type_identity<One>) {
        if (settings.is<One>()) made = One::equipment(settings.of<One>());
    };
    (attempt(std::type_identity<P>{}), ...);
    return made;
}

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
    ParameterList list{{"process", "Process", "", &settings.kind, 0, AllProcesses::kCount - 1, "Kind of the torch.",
                        AllProcesses::kNames, true}};
    for (Parameter& parameter : settingsOf(settings, AllProcesses{}))
        list.push_back(std::move(parameter));
    return list;
}

const ProcessTraits& traitsOf(const ProcessSettings& settings) {
    return *allTraits(AllProcesses{})[static_cast<size_t>(settings.kind)];
}

Equipment equipmentOf(const ProcessSettings& settings) {
    return equipmentIn(settings, AllProcesses{});
}

double Equipment::wireRate() const {
    return std::numbers::pi / 4 * wire * wire * wireSpeed;
}

bool Equipment::withoutGas() const {
    return gas == nullptr || gas == &shieldingGas(GasKind::none) || (wire > 0 && gasFlow <= 0);
}

std::string_view presentProcessName(std::string_view name) {
    for (const ProcessTraits* traits : allTraits(AllProcesses{}))
        if (!traits->formerName.empty() && traits->formerName == name) return traits->name;
    return name;
}

std::unique_ptr<Process> makeProcess(const ProcessSettings& settings, const ProcessMetal& metal) {
    auto made = make(settings, metal, AllProcesses{});
    made->apply(settings);
    return made;
}

std::string_view successorOf(const ProcessSettings& settings, std::string_view key) {
    for (const RetiredSetting& retired : traitsOf(settings).retired)
        if (retired.key == key) return retired.successor;
    return {};
}

} // namespace meltpool
