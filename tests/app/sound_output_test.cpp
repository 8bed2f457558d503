// Sound from a lesson's steps to both ears, through OpenAL's loopback device, and the program's own sound file.
#include "app/sound/openal_device.hpp"
#include "app/sound/sound_output.hpp"
#include "app/sound/sound_stream.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/app/program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/training/feedback/sound/sound_steps.hpp"

#include <chrono>
#include <cmath>
#include <thread>

using namespace meltpool;
using namespace meltpool::test;

namespace {

/// The sound levels of both ears.
struct Ears {
    double left = 0, right = 0;
};

/// Returns the levels of half a second of a long arc at this place.
Ears heardFrom(const glm::vec3& place, float volume = 1) {
    const auto device = OpenAlDevice::openLoopback();
    device->place(place);
    device->volume(volume);
    SoundFeed feed;
    SoundStream stream(feed);
    std::vector<std::int16_t> block(OpenAlDevice::kBlock), both(2 * OpenAlDevice::kBlock);
    Ears ears;
    for (int i = 0; i < 60; ++i) {
        while (feed.push(openArc(Gmaw::kTraits, 0.8F)) && feed.waiting() < 4) {
        }
        for (size_t room = device->room(); room > 0; --room) {
            stream.fill(block);
            device->queue(block);
        }
        device->render(both);
        if (i < 10) continue; // the queue fills, and the level rises
        for (size_t k = 0; k < both.size(); k += 2) {
            ears.left += std::pow(both[k] / 32768.0, 2);
            ears.right += std::pow(both[k + 1] / 32768.0, 2);
        }
    }
    return {std::sqrt(ears.left / 24000), std::sqrt(ears.right / 24000)};
}

/// Returns the samples of a 16-bit file of one channel.
std::vector<float> samplesOf(const std::string& wav) {
    std::vector<float> samples;
    for (size_t i = 44; i + 1 < wav.size(); i += 2) {
        const int value = static_cast<unsigned char>(wav[i]) + 256 * static_cast<signed char>(wav[i + 1]);
        samples.push_back(static_cast<float>(value) / 32768);
    }
    return samples;
}

} // namespace

TEST_CASE("the ear on the arc's side hears more, in front both hear the same, far away less", "[app][sound]") {
    const Ears left = heardFrom({-0.5F, 0, 0}), right = heardFrom({0.5F, 0, 0}), front = heardFrom({0, 0, -0.5F});
    CHECK(left.left > 1.3 * left.right);
    CHECK(right.right > 1.3 * right.left);
    CHECK(front.left == Approx(front.right).epsilon(0.1));
    CHECK(front.left > 0.005);
    const Ears far = heardFrom({0, 0, -3});
    CHECK(far.left < 0.5 * front.left);
    const Ears quiet = heardFrom({0, 0, -0.5F}, 0.25F);
    CHECK(quiet.left == Approx(0.25 * front.left).epsilon(0.05));
    CHECK(heardFrom({0, 0, -0.5F}, 0).left < 1e-4); // the last of 16 bits is dithered
}

TEST_CASE("what the ears get repeats to the last bit", "[app][sound]") {
    const Ears first = heardFrom({0.3F, 0.1F, -0.4F}), second = heardFrom({0.3F, 0.1F, -0.4F});
    CHECK(first.left == second.left);
    CHECK(first.right == second.right);
}

TEST_CASE("a stream lasts over a late frame, falls silent where the lesson stands, and drops what piled up",
          "[app][sound]") {
    SoundFeed feed;
    SoundStream stream(feed);
    std::vector<std::int16_t> block(OpenAlDevice::kBlock);
    const auto level = [&] {
        stream.fill(block);
        double sum = 0;
        for (const std::int16_t sample : block)
            sum += std::pow(sample / 32768.0, 2);
        return std::sqrt(sum / static_cast<double>(block.size()));
    };
    CHECK(level() == 0); // no lesson is open
    for (int i = 0; i < 9; ++i)
        feed.push(openArc(Gmaw::kTraits, 0.8F));
    for (int i = 0; i < 9; ++i)
        level();
    CHECK(stream.withoutStep() < 1000);
    for (int i = 0; i < 15; ++i)
        CHECK(level() > 0.02); // no step for 0.15 s
    for (int i = 0; i < 30; ++i)
        level();
    CHECK(level() == 0); // the lesson is paused
    for (size_t i = 0; i < SoundFeed::kRoom; ++i)
        feed.push(openArc(Gmaw::kTraits, 0.8F));
    level();
    level();
    CHECK(static_cast<double>(feed.waiting()) * kSoundStep < SoundStream::kMost);
    CHECK(level() > 0.02);
}

TEST_CASE("the desk's picture sounds from its direction at a welder's distance", "[app][sound]") {
    const glm::vec3 place = SoundOutput::atDesk({0.03F, 0, -0.04F});
    CHECK(place.x == Approx(0.6 * static_cast<double>(SoundOutput::kDeskDistance)));
    CHECK(place.z == Approx(-0.8 * static_cast<double>(SoundOutput::kDeskDistance)));
    CHECK(SoundOutput::atDesk({0, 0, 0}).z == -SoundOutput::kDeskDistance);
}

TEST_CASE("with a device or without one, the output says which and ends", "[app][sound]") {
    SoundFeed feed;
    SoundOutput output(feed);
    output.update(0.5F, {0, 0, -1});
    for (int i = 0; i < 3000 && !output.known(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(output.known());
    CHECK_FALSE(output.sentence().empty());
    if (!output.plays()) CHECK_THAT(output.sentence(), containsText("no sound"));
}

TEST_CASE("run --sound writes what is heard of the weld, the same bits twice", "[app][sound]") {
    const auto folder = scratchFolder("run-sound");
    const auto torch = folder / "short.toml";
    writeTextFileAtomically(torch, "start_mm = [-2, 3, 0]\n"
                                   "[[move]]\nkind = 'arc_on'\n"
                                   "[[move]]\nkind = 'line'\nto_mm = [2, 3, 0]\nspeed_mm_s = 6\n");
    const auto run = [&](const std::string& name) {
        const Outcome outcome =
            runMeltpool("run gmaw-bead --size 64x48 --pictures 0 --seconds 0.6 --set length_mm=24 --set width_mm=20 "
                        "--set thickness_mm=4 --set cells=32 --torch '" +
                        torch.string() + "' --out '" + (folder / name).string() + "' --sound '" +
                        (folder / (name + ".wav")).string() + "'");
        INFO(outcome.errors);
        REQUIRE(outcome.code == 0);
        return readTextFile(folder / (name + ".wav"));
    };
    const std::string first = run("first");
    CHECK(first.substr(0, 4) == "RIFF");
    CHECK(static_cast<double>(first.size()) == Approx(44 + 2 * 0.6 * 48000).epsilon(0.03));
    const std::vector<float> samples = samplesOf(first);
    CHECK(rootMeanSquare(std::span(samples).last(samples.size() / 2)) > 0.005);
    CHECK(run("second") == first);
}

TEST_CASE("run --sound refuses what has no sound and where no file can be", "[app][sound]") {
    const auto folder = scratchFolder("run-sound-bad");
    const std::string out = " --out '" + (folder / "out").string() + "' --sound ";
    const Outcome silent = runMeltpool("run classic" + out + "'" + (folder / "x.wav").string() + "'");
    CHECK(silent.code == 2);
    CHECK_THAT(silent.errors, containsText("expected a weld"));
    const Outcome nowhere = runMeltpool("run gmaw-bead" + out + "/nowhere/x.wav");
    CHECK(nowhere.code == 2);
    CHECK_THAT(nowhere.errors, containsText("/nowhere"));
}

TEST_CASE("the doctor names the sound device, or says that there is none", "[app][sound]") {
    const Outcome with = runMeltpool("doctor", "env ALSOFT_DRIVERS=null");
    CHECK_THAT(with.output, containsText("device No Output"));
    const Outcome without = runMeltpool("doctor", "env ALSOFT_DRIVERS=nosuch");
    CHECK_THAT(without.output, containsText("no sound device found"));
    CHECK(without.errors.empty());
}
