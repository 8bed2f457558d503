// Settings that belong to the person who welds: size of the text, and the hand of the torch in the headset. All others
// belong to the account.
#pragma once

#include "app/session/settings.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool {

/// Choices of the hand that holds the torch.
std::span<const std::string_view> handChoices();

class PersonSettings {
  public:
    /// Keys of the values that belong to a person.
    static bool has(std::string_view key);

    /// Takes the values in use, which are the account's now. Those that are missing, as without a headset, stay as a
    /// person's file has them. Their storage must outlive this.
    void use(ParameterList values) { live_ = std::move(values); }

    /// Sets the values in use to those in a person's file; a new file begins with the account's. `file`: empty for a
    /// guest, whose values are not stored. Returns one sentence for each fault in the file, as loadSettings() does.
    /// Expects leave() before another person enters.
    std::vector<std::string> enter(const std::filesystem::path& file);
    /// Stores the changes of the person's values and sets those in use to the account's again; no-op for the account.
    /// Returns sentences as saveSettings() does, and one if the file cannot be written.
    std::vector<std::string> leave();

  private:
    struct Values {
        float interfaceSize = 1;
        int hand = 0; ///< index into handChoices()
    };
    static std::vector<SettingsSection> sectionsOf(Values& values);

    ParameterList live_;
    Values account_, person_;
    SettingsValues loaded_;
    std::filesystem::path file_;
    bool entered_ = false;
};

} // namespace meltpool
