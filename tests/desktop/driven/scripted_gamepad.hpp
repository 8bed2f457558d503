// A gamepad that a test works, in place of one at the machine.
#pragma once

#include "tests/desktop/driven/driver.hpp"

#include <functional>
#include <map>
#include <string>

namespace meltpool::test {

class ScriptedGamepad {
  public:
    /// Begins at rest, in the scratch folder `name`.
    explicit ScriptedGamepad(const std::string& name);
    /// Environment of a window that reads this gamepad.
    std::map<std::string, std::string> environment() const { return {{"MELTPOOL_GAMEPAD", file_.string()}}; }

    /// Sets axes and buttons, see gamepadFromText(), and waits until the window has read them.
    void set(TrainerWindow& window, const std::string& text);
    void rest(TrainerWindow& window) { set(window, ""); }
    /// Presses a button, waits for `condition` and releases it.
    void press(TrainerWindow& window, const std::string& button, const std::string& what,
               const std::function<bool(const nlohmann::json&)>& condition);

  private:
    std::filesystem::path file_;
};

} // namespace meltpool::test
