// Tests the file that names the active runtime: a fault in it is reported at once, with its name.
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/environment_change.hpp"
#include "tests/support/gl_fixture.hpp"
#include "xr/diagnosis.hpp"
#include "xr/headset_connection.hpp"
#include "xr/runtime_manifest.hpp"

#include <chrono>
#include <thread>

using namespace meltpool;
using namespace meltpool::test;

namespace {

namespace fs = std::filesystem;

fs::path manifest(const std::string& name, const std::string& text) {
    static const fs::path folder = scratchFolder("manifests");
    const fs::path file = folder / name;
    writeTextFileAtomically(file, text);
    return file;
}

struct Wrong {
    const char* text;
    const char* told;
};

} // namespace

TEST_CASE("a manifest that is missing or no runtime's is named, with what is wrong with it") {
    const Wrong wrong =
        GENERATE(Wrong{"\x01\x02garbage", "is no JSON"}, Wrong{"", "is no JSON"}, Wrong{"{\"runtime\": ", "is no JSON"},
                 Wrong{"[1, 2]", "no object \"runtime\""}, Wrong{"{\"runtime\": 3}", "no object \"runtime\""},
                 Wrong{"{\"runtime\": {}}", "\"library_path\""},
                 Wrong{"{\"runtime\": {\"library_path\": 3}}", "\"library_path\""},
                 Wrong{"{\"runtime\": {\"library_path\": \"\"}}", "empty"},
                 Wrong{"{\"runtime\": {\"library_path\": \"./none.so\"}}", "./none.so, which does not exist"});
    const fs::path file = manifest("runtime.json", wrong.text);
    const xr::RuntimeManifest found = xr::readRuntimeManifest(file);
    INFO(found.fault);
    CHECK_THAT(found.fault, containsText(file.string()) && containsText(wrong.told));
    CHECK_THAT(xr::readRuntimeManifest(file.parent_path()).fault, containsText("is no file"));
    CHECK_THAT(xr::readRuntimeManifest("/nowhere/runtime.json").fault,
               containsText("/nowhere/runtime.json does not exist"));
}

TEST_CASE("a manifest in order has no fault, wherever its library is named from") {
    const fs::path folder = manifest("library.so", "").parent_path();
    const std::string head = "{\"file_format_version\": \"1.0.0\", \"runtime\": {\"library_path\": \"";
    for (const std::string& library : {std::string("./library.so"), (folder / "library.so").string(),
                                       std::string("libopenxr_system.so")}) { // the system searches for this one
        const xr::RuntimeManifest found = xr::readRuntimeManifest(manifest("good.json", head + library + "\"}}"));
        CHECK(found.fault == "");
        CHECK(found.library == library);
    }
    // Runtimes make themselves active by a link in another folder.
    const fs::path link = scratchFolder("manifests-links") / "active_runtime.json";
    fs::create_symlink(manifest("good.json", head + "./library.so\"}}"), link);
    CHECK(xr::readRuntimeManifest(link).fault == "");
}

TEST_CASE("the active runtime is looked for where the loader looks") {
    const fs::path home = scratchFolder("manifests-home"), shared = scratchFolder("manifests-shared");
    const EnvironmentChange none("XR_RUNTIME_JSON", nullptr), config("XDG_CONFIG_HOME", home.c_str()),
        folders("XDG_CONFIG_DIRS", ("/nowhere:" + shared.string()).c_str());
    const fs::path own = home / "openxr/1/active_runtime.json", common = shared / "openxr/1/active_runtime.json";
    fs::create_directories(common.parent_path());
    writeTextFileAtomically(common, "garbage");
    CHECK(xr::findRuntimeManifest().file == common.string());
    fs::create_directories(own.parent_path());
    fs::create_symlink("/nowhere/runtime.json", own); // link to a removed runtime
    CHECK(xr::findRuntimeManifest().file == own.string());
    CHECK_THAT(xr::findRuntimeManifest().fault, containsText("does not exist"));
    const EnvironmentChange named("XR_RUNTIME_JSON", "/else/where.json");
    CHECK_THAT(xr::findRuntimeManifest().fault, containsText("/else/where.json") && containsText("XR_RUNTIME_JSON"));
}

TEST_CASE("connection and doctor say at once what is wrong with the manifest") {
    const fs::path file = manifest("broken.json", "not JSON");
    const EnvironmentChange named("XR_RUNTIME_JSON", file.c_str());
    const xr::Diagnosis told = xr::diagnose(false);
    CHECK_FALSE(told.usable);
    CHECK_THAT(told.advice, containsText(file.string()) && containsText("is no JSON"));
    REQUIRE(told.facts.front().name == "active runtime");
    CHECK_FALSE(told.facts.front().good);

    xr::HeadsetConnection connection({});
    const auto begin = std::chrono::steady_clock::now();
    while (!connection.hopeless() && std::chrono::steady_clock::now() - begin < std::chrono::seconds(30)) {
        CHECK(connection.update() == xr::ConnectionState::searching);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(connection.hopeless());
    CHECK(connection.manifestAtFault());
    CHECK_THAT(connection.reason(), containsText(file.string()));
}
