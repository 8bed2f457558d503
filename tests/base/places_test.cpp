// The user's folders on Linux: without a home in the environment, with relative names, and in the user's language.
#ifdef __linux__
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/environment_change.hpp"
#include "tests/support/gl_fixture.hpp"

#include <pwd.h>
#include <unistd.h>

using namespace meltpool;
using meltpool::test::EnvironmentChange;

namespace fs = std::filesystem;

TEST_CASE("without HOME the home is that of the user database, never the working folder", "[base]") {
    const passwd* user = getpwuid(getuid());
    REQUIRE(user != nullptr);
    const fs::path home = user->pw_dir;
    const char* value = GENERATE(as<const char*>(), nullptr, "", "here/below");
    const EnvironmentChange unset("HOME", value), config("XDG_CONFIG_HOME", nullptr), data("XDG_DATA_HOME", nullptr),
        cache("XDG_CACHE_HOME", nullptr), pictures("XDG_PICTURES_DIR", nullptr);
    CHECK(userSettings() == home / ".config");
    CHECK(userFiles() == home / ".local" / "share");
    CHECK(userCache() == home / ".cache");
    CHECK(settingsFolder().is_absolute());
}

TEST_CASE("a relative folder of XDG is ignored, an absolute one is used", "[base]") {
    const EnvironmentChange home("HOME", "/home/of-a-test");
    {
        const EnvironmentChange config("XDG_CONFIG_HOME", "config"), data("XDG_DATA_HOME", "./data"),
            cache("XDG_CACHE_HOME", "../cache"), pictures("XDG_PICTURES_DIR", "pictures");
        CHECK(userSettings() == "/home/of-a-test/.config");
        CHECK(userFiles() == "/home/of-a-test/.local/share");
        CHECK(userCache() == "/home/of-a-test/.cache");
        CHECK(userPictures() == "/home/of-a-test/Pictures");
    }
    const EnvironmentChange config("XDG_CONFIG_HOME", "/c"), data("XDG_DATA_HOME", "/d"), cache("XDG_CACHE_HOME", "/e"),
        pictures("XDG_PICTURES_DIR", "/p");
    CHECK(userSettings() == "/c");
    CHECK(userFiles() == "/d");
    CHECK(userCache() == "/e");
    CHECK(userPictures() == "/p");
}

TEST_CASE("pictures go where user-dirs.dirs says", "[base]") {
    const fs::path config = test::scratchFolder("user-dirs");
    const EnvironmentChange home("HOME", "/home/of-a-test"), folder("XDG_CONFIG_HOME", config.c_str()),
        pictures("XDG_PICTURES_DIR", nullptr);
    const auto placeFor = [&](const std::string& text) {
        writeTextFileAtomically(config / "user-dirs.dirs", text);
        return userPictures();
    };
    CHECK(placeFor("# comment\nXDG_MUSIC_DIR=\"$HOME/Musik\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n") ==
          "/home/of-a-test/Bilder");
    CHECK(placeFor("  XDG_PICTURES_DIR=\"$HOME/Im\xC3\xA1genes\"") == "/home/of-a-test/Im\xC3\xA1genes");
    CHECK(placeFor("XDG_PICTURES_DIR=\"/data/our \\\"own\\\"\"\n") == "/data/our \"own\"");
    CHECK(placeFor("XDG_PICTURES_DIR=\"$HOME/\"\n") == "/home/of-a-test/"); // a switched-off folder is the home itself
    for (const char* unusable : {"", "#XDG_PICTURES_DIR=\"$HOME/Bilder\"\n", "XDG_PICTURES_DIR=\"Bilder\"\n",
                                 "XDG_PICTURES_DIR=\"$HOME/Bilder\n", "XDG_PICTURES_DIR=\"$HOMEX/Bilder\"\n",
                                 "XDG_PICTURES_DIRS=\"/x\"\n", "XDG_PICTURES_DIR=$HOME/Bilder\n"}) {
        INFO(unusable);
        CHECK(placeFor(unusable) == "/home/of-a-test/Pictures");
    }
}
#endif
