#include "app/session/person_settings.hpp"

#include "core/base/words.hpp"

#include <array>

namespace meltpool {

namespace {

/// Copies the values that both lists have.
void copyKnown(const ParameterList& from, const ParameterList& to) {
    for (const Parameter& p : from)
        if (findParameter(to, p.key) != nullptr) setParameter(to, p.key, parameterText(p), "person");
}

} // namespace

std::span<const std::string_view> handChoices() {
    static constexpr std::array<std::string_view, 2> kHands{"right", "left"};
    return kHands;
}

bool PersonSettings::has(std::string_view key) {
    return key == "interface_size" || key == "hand";
}

std::vector<SettingsSection> PersonSettings::sectionsOf(Values& values) {
    return {
        {"person",
         {{"interface_size", "Size of text and menus", "", &values.interfaceSize, 0.7, 2,
           "Factor on the desktop's own scale. Large menus cover more of the picture."},
          {"hand", "Torch in the hand", "", &values.hand, 0, 1, "The other hand holds the pointer.", handChoices()}}}};
}

std::vector<std::string> PersonSettings::enter(const std::filesystem::path& file) {
    copyKnown(live_, sectionsOf(account_).front().parameters);
    person_ = account_;
    file_ = file;
    entered_ = true;
    const std::vector<SettingsSection> sections = sectionsOf(person_);
    std::vector<std::string> faults;
    if (!file_.empty()) faults = loadSettings(file_, sections);
    loaded_ = valuesOf(sections);
    copyKnown(sections.front().parameters, live_);
    return faults;
}

std::vector<std::string> PersonSettings::leave() {
    if (!std::exchange(entered_, false)) return {};
    const std::vector<SettingsSection> sections = sectionsOf(person_);
    copyKnown(live_, sections.front().parameters);
    copyKnown(sectionsOf(account_).front().parameters, live_);
    if (file_.empty()) return {};
    try {
        return saveSettings(file_, sections, loaded_);
    } catch (const std::exception& fault) {
        return {phrase("desk.message.settings_not_saved", {{"reason", fault.what()}})};
    }
}

} // namespace meltpool
