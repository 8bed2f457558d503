// Tests the window without a sound device, and the switches of the sound.
#include "core/base/text.hpp"
#include "tests/desktop/driven/driver.hpp"
#include "tests/support/catch.hpp"

namespace meltpool::test {

using nlohmann::json;

TEST_CASE("without a sound device the trainer starts and ends as before, and keeps the switches of the sound") {
    const std::string settings = [] {
        TrainerWindow window("no-sound", {.environment = {{"ALSOFT_DRIVERS", "nosuch"}}});
        window.start();
        const json s = window.waitFor("the metal to run", [](const json& t) { return t.at("metal").at("steps") > 10; });
        CHECK(parameterIn(s, "sound", "volume") == "0.6");
        CHECK(parameterIn(s, "sound", "captions") == "false");
        CHECK(s.at("messages").empty());
        window.click("bar.view");
        window.click("sound.group.Sound");
        window.change("sound", "captions", [&] { window.click("sound.captions"); });
        CHECK(parameterIn(window.state(), "sound", "captions") == "true");
        window.closeWindow();
        CHECK(window.finish() == 0);
        CHECK(window.output().empty());
        return readTextFile(window.settingsFile());
    }();
    CHECK_THAT(settings, containsText("[sound]"));
    CHECK_THAT(settings, containsText("captions = true"));
}

} // namespace meltpool::test
