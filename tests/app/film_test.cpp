// Films of `meltpool run`: a time-lapse with and without ffmpeg, and a turntable.
#include "app/export/film.hpp"
#include "app/report/attempt_pictures.hpp"
#include "core/base/error.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <fstream>

using namespace meltpool;
using meltpool::test::containsText;
using meltpool::test::runMeltpool;

namespace {

namespace fs = std::filesystem;

/// Six pictures, at 0, 0.1, .. 0.5 s.
const std::string kQuick = "run classic --size 160x120 --set cells=24 --set particles=512 --pictures 0 --seconds 0.5 ";
const std::string kVideo = "--video --video-rate 10 --video-speed 1 ";

std::string numberedFile(const std::string& name, int digits, int number) {
    std::string text = std::to_string(number);
    return name + std::string(static_cast<size_t>(digits) - text.size(), '0') + text + ".png";
}

size_t countOf(const fs::path& folder, const std::string& begin) {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(begin)) ++count;
    return count;
}

/// Makes a folder with an ffmpeg that writes its arguments to words.txt and runs this script.
fs::path folderWithEncoder(const fs::path& folder, const std::string& script) {
    fs::create_directories(folder);
    const fs::path program = folder / "ffmpeg";
    std::ofstream(program) << "#!/bin/sh\nprintf '%s\\n' \"$@\" > '" << (folder / "words.txt").string() << "'\n"
                           << script << "\n";
    fs::permissions(program, fs::perms::owner_all);
    return folder;
}

} // namespace

TEST_CASE("a time-lapse takes a picture whenever one of its own is due", "[app]") {
    const auto folder = test::scratchFolder("film-due");
    const Image picture{1, 1, {1, 2, 3}};
    FilmRequest request;
    request.video = true;
    request.rate = 10;
    request.speed = 2; // pictures every 0.2 s
    Film film(request, folder);
    CHECK(film.due(0, 0.005) == 1);
    film.add(picture, 1);
    CHECK(film.due(0.1, 0.005) == 0);
    CHECK(film.due(0.196, 0.005) == 1);
    CHECK(film.due(0.65, 0.005) == 3); // pictures come slower than steps
    film.add(picture, 3);
    CHECK(film.due(0.65, 0.005) == 0);
    CHECK(countOf(folder, "video-") == 4);
    CHECK(fs::exists(folder / "video-000003.png"));
    request.video = false;
    CHECK(Film(request, folder).due(10, 0) == 0);
}

TEST_CASE("a turntable closes: its last picture's next is its first", "[app]") {
    const Lesson lesson = findLesson("gmaw-bead", resourceFolder() / "data" / "lessons");
    const PictureLook look = filmLook(lesson);
    CHECK_FALSE(look.sectionAt);
    for (const int pictures : {2, 7, 36}) {
        const float first = turnedLook(look, 0, pictures).camera.azimuth;
        CHECK(first == Approx(std::remainder(look.camera.azimuth, 360.0f)));
        CHECK(turnedLook(look, pictures, pictures).camera.azimuth == first);
        const float second = turnedLook(look, 1, pictures).camera.azimuth;
        CHECK(std::remainder(second - first - 360.0f / static_cast<float>(pictures), 360.0f) == Approx(0).margin(1e-3));
    }
    CHECK_FALSE(turnedLook(look, 0, 4).look.showSource);
}

TEST_CASE("a run without ffmpeg leaves the time-lapse as pictures and says so, and its turntable", "[app]") {
    const auto folder = test::scratchFolder("film");
    const test::Outcome outcome =
        runMeltpool(kQuick + kVideo + "--turntable 4 --out '" + (folder / "out").string() + "'", "PATH=/nowhere");
    INFO(outcome.errors);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.output, containsText("6 pictures, 0.6 s"));
    CHECK_THAT(outcome.output, containsText("ffmpeg"));
    CHECK_THAT(outcome.output, containsText("is not in PATH"));
    REQUIRE(countOf(folder / "out", "video-") == 6);
    REQUIRE(countOf(folder / "out", "turntable-") == 4);
    std::vector<Image> frames, turned;
    for (int i = 0; i < 6; ++i)
        frames.push_back(readPng(folder / "out" / numberedFile("video-", 6, i)));
    for (int i = 0; i < 4; ++i)
        turned.push_back(readPng(folder / "out" / numberedFile("turntable-", 3, i)));
    for (const std::vector<Image>* pictures : {&frames, &turned})
        for (const Image& each : *pictures) {
            CHECK(each.width == 160);
            CHECK(each.height == 120);
        }
    CHECK(compareImages(frames.front(), frames.back(), 8).farPixels > 0);
    CHECK(compareImages(turned[0], turned[1], 8).farPixels > 0.01);
    // A later run into this folder removes them.
    const test::Outcome again = runMeltpool(kQuick + "--out '" + (folder / "out").string() + "'");
    CHECK(again.code == 0);
    CHECK(countOf(folder / "out", "video-") + countOf(folder / "out", "turntable-") == 0);
}

#ifndef _WIN32
TEST_CASE("where ffmpeg is, a video is made of the time-lapse without a shell, and the pictures go", "[app]") {
    const auto folder = test::scratchFolder("film-video");
    const fs::path tools = folderWithEncoder(folder / "tools", "for last; do :; done; echo video > \"$last\"");
    const fs::path out = folder / "a 100% 'odd' $HOME folder";
    const test::Outcome outcome =
        runMeltpool(kQuick + kVideo + "--out \"" + folder.string() + "/a 100% 'odd' \\$HOME folder\"",
                    "PATH='" + tools.string() + ":/usr/bin:/bin'");
    INFO(outcome.errors);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.output, containsText("video.mp4"));
    CHECK(readTextFile(out / "video.mp4") == "video\n");
    CHECK(countOf(out, "video-") == 0);
    const std::string words = readTextFile(tools / "words.txt");
    CHECK_THAT(words, containsText("-framerate\n10\n"));
    CHECK_THAT(words, containsText("/a 100%% 'odd' $HOME folder/video-%06d.png\n"));
}

TEST_CASE("an ffmpeg that fails costs the video, not the pictures", "[app]") {
    const auto folder = test::scratchFolder("film-fails");
    const fs::path tools = folderWithEncoder(folder / "tools", "exit 3");
    const test::Outcome outcome = runMeltpool(kQuick + kVideo + "--out '" + (folder / "out").string() + "'",
                                              "PATH='" + tools.string() + ":/usr/bin:/bin'");
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.errors, containsText("ffmpeg made no video of the time-lapse (exit code 3)"));
    CHECK(countOf(folder / "out", "video-") == 6);
    CHECK(fs::exists(folder / "out" / "result.json"));
}
#endif

TEST_CASE("options of the time-lapse and the turntable that make no sense are refused in a sentence", "[app]") {
    const auto folder = test::scratchFolder("film-bad");
    for (const char* bad :
         {"--video --video-rate 0", "--video --video-rate fast", "--video --video-speed -1", "--video --video-speed 0",
          "--turntable 1", "--turntable 1000000", "--turntable x", "--video-rate 25", "--video-speed 2"}) {
        INFO(bad);
        const test::Outcome outcome = runMeltpool(kQuick + bad + " --out '" + (folder / "out").string() + "'");
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.errors, containsText("expected"));
        CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
        CHECK_FALSE(fs::exists(folder / "out"));
    }
}
