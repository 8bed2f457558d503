// `meltpool run` as a command: its files, its repeatability, odd particle counts, and failures midway.
#include "core/base/image.hpp"
#include "core/base/text.hpp"
#include "core/weld/torch/torch_csv.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <nlohmann/json.hpp>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A run that a software driver finishes in about a second.
const std::string kQuick = "run classic --size 160x120 --set cells=24 ";

Json resultIn(const fs::path& folder) {
    return Json::parse(readTextFile(folder / "result.json"));
}

Json runInto(const fs::path& folder, const std::string& arguments) {
    const test::Outcome outcome = runMeltpool(arguments + " --out '" + folder.string() + "'");
    INFO(outcome.errors);
    REQUIRE(outcome.code == 0);
    REQUIRE(outcome.errors.empty());
    return resultIn(folder);
}

size_t picturesIn(const fs::path& folder) {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".png") {
            const Image image = readPng(entry.path());
            CHECK(image.width == 160);
            CHECK(image.height == 120);
            ++count;
        }
    return count;
}

} // namespace

TEST_CASE("a run says which sizes of the workpiece whole layers of particles change, and keeps them", "[app]") {
    const auto folder = test::scratchFolder("sizes");
    const std::string arguments = "run gmaw-bead --size 160x120 --seconds 0.02 --pictures 0 --set cells=24"
                                  " --set length_mm=20 --set width_mm=16 --set thickness_mm=";
    const std::string text = "Particles of 1 mm make whole layers only. Thickness is 5 mm instead of 4.5 mm. "
                             "Particles of 0.9 mm keep the thickness.";
    const test::Outcome changed = runMeltpool(arguments + "4.5 --out '" + (folder / "changed").string() + "'");
    INFO(changed.errors);
    REQUIRE(changed.code == 0);
    CHECK_THAT(changed.output, containsText(text));
    const Json result = resultIn(folder / "changed");
    CHECK(result["simulated"] == Json({{"thickness_mm", 5}}));
    CHECK(result["simulated_text"] == text);
    CHECK(result["parameters"]["thickness_mm"] == 4.5);
    CHECK(result["particles"] == 20 * 16 * 5);
    const Json whole = runInto(folder / "whole", arguments + "5");
    CHECK_FALSE(whole.contains("simulated"));
    CHECK_FALSE(whole.contains("simulated_text"));
    CHECK(whole["state_hash"] == result["state_hash"]);
}

TEST_CASE("a run leaves result, telemetry and pictures, and the same run gives the same state", "[app]") {
    const auto folder = test::scratchFolder("run");
    const std::string arguments = kQuick + "--seconds 1 --pictures 0.5 --set particles=8191 --set support_radius=0.07";
    const Json first = runInto(folder / "first", arguments);
    for (const char* field :
         {"lesson", "renderer", "seconds", "steps", "particles", "min_temperature", "mean_temperature",
          "max_temperature", "molten", "lost", "non_finite", "state_hash", "wall_seconds", "parameters"})
        CHECK(first.contains(field));
    CHECK(first["lesson"] == "classic");
    CHECK(first["steps"] == 60);
    CHECK(first["seconds"].get<double>() == Approx(1).margin(1e-4));
    CHECK(first["particles"] == 8191);
    CHECK(first["lost"] == 0);
    CHECK(first["non_finite"] == 0);
    CHECK(first["molten"] > 0);
    CHECK(first["molten"] < 8191);
    CHECK(first["min_temperature"] == 0);
    CHECK_FALSE(first.contains("error"));
    CHECK(first["finished"] == true);
    CHECK(picturesIn(folder / "first") == 6); // 0, 0.5 and 1 s in two looks
    CHECK(readTorchCsv(folder / "first" / "telemetry.csv").samples.size() == 60);

    const Json second = runInto(folder / "second", arguments);
    CHECK(second["state_hash"] == first["state_hash"]);
    CHECK(second["molten"] == first["molten"]);

    // The record is a torch path that reproduces the metal.
    const Json again =
        runInto(folder / "again", arguments + " --torch '" + (folder / "first" / "telemetry.csv").string() + "'");
    CHECK(again["state_hash"] == first["state_hash"]);
    CHECK(readTextFile(folder / "again" / "telemetry.csv") == readTextFile(folder / "first" / "telemetry.csv"));
}

TEST_CASE("odd numbers of particles lose none", "[app]") {
    const auto folder = test::scratchFolder("odd");
    for (const int particles : {1, 63, 65, 1021}) {
        INFO(particles);
        const Json result = runInto(folder / std::to_string(particles),
                                    kQuick + "--pictures 0 --seconds 0.9 --set support_radius=0.15 --set particles=" +
                                        std::to_string(particles) + " --set heat_radius=8 --set solidify_rate=0");
        CHECK(result["particles"] == particles);
        CHECK(result["lost"] == 0);
        CHECK(result["non_finite"] == 0);
        CHECK(result["molten"] == particles);
    }
}

TEST_CASE("a run of no length takes its pictures and ends", "[app]") {
    const auto folder = test::scratchFolder("none");
    const Json result = runInto(folder, kQuick + "--pictures 0 --seconds 0 --set particles=64");
    CHECK(result["steps"] == 0);
    CHECK(picturesIn(folder) == 2);
}

TEST_CASE("when the disk is full midway the rest is kept and the result says why", "[app]") {
    if (!fs::exists("/dev/full")) return;
    const auto folder = test::scratchFolder("full");
    fs::create_symlink("/dev/full", folder / "telemetry.csv");
    const test::Outcome outcome =
        runMeltpool(kQuick + "--pictures 0 --seconds 0.5 --set particles=64 --out '" + folder.string() + "'");
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.errors, containsText("telemetry.csv"));
    CHECK_THAT(resultIn(folder).at("error").get<std::string>(), containsText("telemetry.csv"));
}

TEST_CASE("a picture that cannot be written keeps the record up to there", "[app]") {
    const auto folder = test::scratchFolder("picture");
    fs::create_directories(folder / "000.500s-metal.png");
    const test::Outcome outcome =
        runMeltpool(kQuick + "--seconds 1 --pictures 0.5 --set particles=64 --out '" + folder.string() + "'");
    CHECK(outcome.code == 1);
    CHECK_THAT(resultIn(folder).at("error").get<std::string>(), containsText("000.500s-metal.png"));
    CHECK(readTorchCsv(folder / "telemetry.csv").samples.size() == 30);
}

TEST_CASE("a run that is stopped by a signal keeps what it had", "[app]") {
    const auto folder = test::scratchFolder("signal");
    const test::Outcome outcome = test::runUntilRecorded(
        kQuick + "--pictures 0 --seconds 3600 --set particles=512 --out '" + folder.string() + "'",
        folder / "telemetry.csv");
    CHECK(outcome.code == 1);
    const Json result = resultIn(folder);
    CHECK_THAT(result.at("error").get<std::string>(), containsText("stopped"));
    CHECK(readTorchCsv(folder / "telemetry.csv").samples.size() == result.at("steps").get<size_t>());
}

TEST_CASE("without a display the program says so and runs the demonstration", "[app]") {
    const auto folder = test::scratchFolder("demonstration");
    const test::Outcome outcome =
        test::runUntilRecorded("", folder / "out" / "classic" / "telemetry.csv",
                               "cd '" + folder.string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY");
    CHECK(outcome.code == 1); // the run stops before its end
    CHECK_THAT(outcome.output, containsText("There is no display"));
    CHECK(resultIn(folder / "out" / "classic").at("lesson") == "classic");
    CHECK(fs::exists(folder / "out" / "classic" / "000.000s-metal.png"));
}

TEST_CASE("a weld lesson melts steel, tells its section, and repeats bit by bit", "[app]") {
    const auto folder = test::scratchFolder("weld");
    const auto torch = folder / "short.toml";
    writeTextFileAtomically(torch, "start_mm = [-2, 3, 0]\n"
                                   "[[move]]\nkind = 'arc_on'\n"
                                   "[[move]]\nkind = 'line'\nto_mm = [2, 3, 0]\nspeed_mm_s = 6\n");
    const std::string arguments = "run gmaw-bead --size 160x120 --pictures 0 --seconds 0.6 --set length_mm=24 "
                                  "--set width_mm=20 --set thickness_mm=4 --set cells=32 --torch '" +
                                  torch.string() + "'";
    const Json first = runInto(folder / "first", arguments);
    CHECK(first.at("molten") > 0);
    CHECK(first.at("lost") == 0);
    CHECK(first.at("non_finite") == 0);
    CHECK(first.at("max_temperature_c") > 1450);
    CHECK(first.at("min_temperature_c").get<double>() == Approx(20).margin(1));
    CHECK_THAT(readTextFile(folder / "first" / "telemetry.csv"),
               containsText(",min_temperature_c,mean_temperature_c,max_temperature_c,"));
    const Json& section = first.at("section");
    CHECK(section.at("at_mm") == 0);
    for (const char* size : {"width_mm", "height_mm", "depth_mm", "area_mm2"})
        CHECK(section.at("heat_affected").at(size) >= section.at("fusion").at(size));
    CHECK(section.at("heat_affected").at("area_mm2") > 1);
    // A ghost only changes the picture.
    const auto other = folder / "other.toml";
    writeTextFileAtomically(other, "start_mm = [-4, 3, 0]\ntravel_angle_deg = -30\n"
                                   "[[move]]\nkind = 'arc_on'\n"
                                   "[[move]]\nkind = 'line'\nto_mm = [6, 3, 0]\nspeed_mm_s = 5\n");
    const Json second = runInto(folder / "second", arguments + " --ghost '" + other.string() + "'");
    CHECK(second.at("state_hash") == first.at("state_hash"));
    CHECK(second.at("section") == section);
    const auto picture = [&](const char* run) {
        for (const auto& entry : fs::directory_iterator(folder / run))
            if (entry.path().filename().string().ends_with("-metal.png")) return readPng(entry.path());
        return Image{};
    };
    CHECK(compareImages(picture("first"), picture("second"), 10).farPixels > 0.002);
}

TEST_CASE("a ghost that cannot be one is refused with a sentence", "[app]") {
    const auto folder = test::scratchFolder("no-ghost");
    const auto still = folder / "still.toml";
    writeTextFileAtomically(still, "start_mm = [0, 3, 0]\n[[move]]\nkind = 'hold'\nseconds = 1\n");
    const std::string into = " --seconds 0.1 --out '" + (folder / "out").string() + "' --ghost '";
    for (const auto& [arguments, sentence] :
         {std::pair<std::string, std::string>{kQuick + into + still.string(), "--ghost is for weld lessons"},
          {"run gmaw-bead" + into + (folder / "none.csv").string(), "none.csv"},
          {"run gmaw-bead" + into + still.string(), "still.toml: never pulls the trigger; expected"}}) {
        INFO(arguments);
        const test::Outcome outcome = runMeltpool(arguments + "'");
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText(sentence));
    }
    CHECK_FALSE(fs::exists(folder / "out" / "result.json"));
}

TEST_CASE("a size limit on files ends a run with a sentence and without a cut picture", "[app]") {
    const auto folder = test::scratchFolder("limit");
    // The size in KiB is enough for the record's rows, too small for a picture.
    const test::Outcome outcome =
        runMeltpool("run classic --size 640x480 --set cells=24 --set particles=512 --seconds 0.1 "
                    "--pictures 0 --out '" +
                        folder.string() + "'",
                    "ulimit -f 8;");
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.errors, containsText("-metal.png: cannot be written to its end"));
    for (const auto& entry : fs::directory_iterator(folder))
        CHECK(entry.path().extension() != ".png");
}

TEST_CASE("a run never writes over the torch path that it reads", "[app]") {
    const auto folder = test::scratchFolder("source");
    runInto(folder, kQuick + "--pictures 0 --seconds 0.1 --set particles=64");
    const std::string record = readTextFile(folder / "telemetry.csv");
    fs::create_hard_link(folder / "telemetry.csv", folder / "other-name.csv");
    for (const char* name : {"telemetry.csv", "other-name.csv"}) {
        const test::Outcome outcome = runMeltpool(kQuick + "--seconds 0.1 --torch '" + (folder / name).string() +
                                                  "' --out '" + folder.string() + "'");
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText(std::string(name) + ": the run would write over this file"));
    }
    CHECK(readTextFile(folder / "telemetry.csv") == record);
    CHECK(resultIn(folder).at("finished") == true);
}

TEST_CASE("a folder in which a run writes is closed to a second one, and a killed run is marked as unfinished",
          "[app]") {
    const auto folder = test::scratchFolder("twice");
    const std::string into = " --out '" + folder.string() + "'";
    runInto(folder, kQuick + "--pictures 0.05 --seconds 0.2 --set particles=64");
    const test::Outcome second =
        test::runBeside(kQuick + "--pictures 0 --seconds 3600 --set particles=512" + into, "KILL",
                        folder / "telemetry.csv", kQuick + "--seconds 0.1 --set particles=64" + into);
    CHECK(second.code == 2);
    CHECK_THAT(second.errors, containsText("twice: another program is writing here") && containsText("expected"));
    const Json killed = resultIn(folder);
    CHECK(killed.at("finished") == false);
    CHECK_THAT(killed.at("error").get<std::string>(), containsText("has not ended"));
    CHECK_FALSE(killed.contains("state_hash"));
    CHECK(picturesIn(folder) == 0); // the first run's pictures are removed
    // A dead process holds no lock.
    const test::Outcome third = runMeltpool(kQuick + "--pictures 0 --seconds 0.1 --set particles=64" + into);
    CHECK(third.code == 0);
    CHECK_THAT(third.output, containsText("held an earlier run; its 2 files are removed"));
    CHECK(resultIn(folder).at("finished") == true);
    CHECK_FALSE(fs::exists(folder / "meltpool.lock"));
}

TEST_CASE("a run that cannot begin says so in its result", "[app]") {
    const auto folder = test::scratchFolder("beginning");
    const fs::path data = folder / "data";
    fs::create_directories(data);
    fs::copy(test::testFolder().parent_path() / "shaders", data / "shaders", fs::copy_options::recursive);
    fs::create_directory_symlink(test::testFolder().parent_path() / "app" / "data", data / "data");
    for (const auto& entry : fs::recursive_directory_iterator(data / "shaders" / "metal" / "classic"))
        if (entry.path().extension() == ".comp") writeTextFileAtomically(entry.path(), "no shader");
    const test::Outcome outcome = runMeltpool(kQuick + "--set particles=64 --out '" + (folder / "out").string() + "'",
                                              "env MELTPOOL_DATA='" + data.string() + "'");
    CHECK(outcome.code != 0);
    CHECK(resultIn(folder / "out").at("finished") == false);
    CHECK_THAT(resultIn(folder / "out").at("error").get<std::string>(), containsText(".comp"));
}

TEST_CASE("a run with shaders of another version is refused with one sentence", "[app]") {
    const auto folder = test::scratchFolder("other-version");
    fs::copy(test::testFolder().parent_path() / "shaders", folder / "shaders", fs::copy_options::recursive);
    fs::create_directory_symlink(test::testFolder().parent_path() / "app" / "data", folder / "data");
    std::string text = readTextFile(folder / "shaders" / "shared" / "classic.h");
    text.replace(text.find("    float solidifyRate;"), 0, "    vec4 more;\n");
    writeTextFileAtomically(folder / "shaders" / "shared" / "classic.h", text);
    const test::Outcome outcome = runMeltpool(kQuick + "--set particles=64 --out '" + (folder / "out").string() + "'",
                                              "env MELTPOOL_DATA='" + folder.string() + "'");
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.errors, containsText("block 'StepBlock' (struct ClassicStep) has 112 bytes, but 96") &&
                                   containsText("set MELTPOOL_DATA to the folder"));
}

TEST_CASE("a run that this machine cannot hold is refused before its folder is touched", "[app]") {
    const auto folder = test::scratchFolder("room");
    runInto(folder, kQuick + "--pictures 0 --seconds 0.1 --set particles=64");
    const std::string result = readTextFile(folder / "result.json");
    for (const char* size : {"--set spacing_mm=0.2 --set length_mm=400 --set width_mm=400 --set thickness_mm=50",
                             "--set spacing_mm=0.5 --set length_mm=400 --set width_mm=400 --set thickness_mm=50"}) {
        INFO(size);
        const test::Outcome outcome =
            runMeltpool(std::string("run gmaw-bead ") + size + " --out '" + folder.string() + "'");
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText("spacing_mm") && containsText("expected"));
    }
    CHECK(readTextFile(folder / "result.json") == result);
}

TEST_CASE("without a display lesson and record are honoured, and what needs a window is refused", "[app]") {
    const auto folder = test::scratchFolder("options");
    const std::string before = "cd '" + folder.string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY";
    for (const char* option : {"--headset", "--telemetry rows.json", "--watch-shaders"}) {
        INFO(option);
        const test::Outcome outcome = runMeltpool(option, before);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText(std::string(option).substr(0, 8)) && containsText("expected"));
        CHECK_FALSE(fs::exists(folder / "out"));
    }
    CHECK(runMeltpool("--lesson missing.toml", before).code == 2);
    const test::Outcome outcome =
        test::runUntilRecorded("--lesson solder-cube --record mine.csv", folder / "mine.csv", before);
    CHECK(outcome.code == 1); // the run stops before its end
    CHECK_THAT(outcome.output, containsText("lesson 'solder-cube' runs"));
    CHECK(resultIn(folder / "out" / "solder-cube").at("lesson") == "solder-cube");
    CHECK_FALSE(readTorchCsv(folder / "mine.csv").samples.empty());
    CHECK(runMeltpool("--record /no/such/folder/mine.csv", before).code == 2);
}
