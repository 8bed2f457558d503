#include "tests/desktop/driven/scripted_gamepad.hpp"

#include "core/base/text.hpp"
#include "tests/support/gl_fixture.hpp"

namespace meltpool::test {

ScriptedGamepad::ScriptedGamepad(const std::string& name) : file_(scratchFolder(name) / "gamepad.txt") {
    writeTextFileAtomically(file_, "");
}

void ScriptedGamepad::set(TrainerWindow& window, const std::string& text) {
    window.act([&] { writeTextFileAtomically(file_, text); });
    window.settle();
}

void ScriptedGamepad::press(TrainerWindow& window, const std::string& button, const std::string& what,
                            const std::function<bool(const nlohmann::json&)>& condition) {
    set(window, button);
    window.waitFor(what, condition);
    rest(window);
}

} // namespace meltpool::test
