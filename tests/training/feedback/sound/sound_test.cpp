// The sound synthesis for synthetic arcs.
#include "core/training/feedback/haptics.hpp"
#include "core/training/feedback/sound/sound_track.hpp"
#include "core/weld/process/shielding_gas.hpp"
#include "tests/support/catch.hpp"
#include "tests/training/feedback/sound/sound_steps.hpp"

#include <algorithm>
#include <functional>

using namespace meltpool;
using namespace meltpool::test;

namespace {

/// Returns the clicks: places where the sound rises over `loud`, except for `rings` s of ringing after each.
size_t clicksIn(std::span<const float> samples, float loud, double rings = 1.5e-3) {
    size_t clicks = 0;
    const auto pause = static_cast<size_t>(rings * Sound::kRate);
    for (size_t i = 0; i < samples.size(); ++i)
        if (std::abs(samples[i]) > loud) {
            ++clicks;
            i += pause;
        }
    return clicks;
}

float loudest(std::span<const float> samples) {
    float most = 0;
    for (const float sample : samples)
        most = std::max(most, std::abs(sample));
    return most;
}

bool isSilent(std::span<const float> samples) {
    return loudest(samples) == 0;
}

/// Returns Pearson's correlation, -1..1.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto mean = [](const std::vector<double>& of) {
        double sum = 0;
        for (const double each : of)
            sum += each;
        return sum / static_cast<double>(of.size());
    };
    const double middleA = mean(a), middleB = mean(b);
    double both = 0, squareA = 0, squareB = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        both += (a[i] - middleA) * (b[i] - middleB);
        squareA += (a[i] - middleA) * (a[i] - middleA);
        squareB += (b[i] - middleB) * (b[i] - middleB);
    }
    return both / std::sqrt(squareA * squareB);
}

SoundStep stubbedWire() {
    SoundStep step = openArc(Gmaw::kTraits);
    step.arc.action = ArcAction::stubbed;
    return step;
}

} // namespace

TEST_CASE("as many clicks are heard as short circuits are counted", "[sound]") {
    for (const float rate : {25.0F, 120.0F, 168.0F}) {
        Sound sound;
        ShortCircuits shorts;
        std::vector<float> samples, strike;
        append(strike, sound, openArc(Gmaw::kTraits)); // the arc's own beginning is not a short circuit
        for (int i = 0; i < 60; ++i)
            append(strike, sound, openArc(Gmaw::kTraits));
        for (int i = 0; i < 900; ++i)
            append(samples, sound, shorting(shorts, rate));
        INFO(rate);
        CHECK(static_cast<double>(shorts.count()) > 9 * static_cast<double>(rate));
        CHECK(clicksIn(samples, 0.15F) == shorts.count());
    }
}

TEST_CASE("a click is as loud as the step of power", "[sound]") {
    const auto click = [](float current) {
        SoundStep step = openArc(Gmaw::kTraits);
        step.arc.action = ArcAction::shorting;
        step.arc.stretch = 0;
        Sound sound;
        std::vector<float> samples;
        for (int i = 0; i < 90; ++i)
            append(samples, sound, step); // the strike dies away
        step.shorts[0] = {0.002F, 20 * current};
        step.shortCount = 1;
        std::vector<float> heard;
        append(heard, sound, step);
        return static_cast<double>(loudest(heard));
    };
    CHECK(click(200) > click(100) + 0.15);
    CHECK(click(200) == Approx(2 * click(100)).epsilon(0.3));
}

TEST_CASE("the noise of an open arc rises in level and pitch with its length", "[sound]") {
    for (const ProcessTraits* process : {&Gmaw::kTraits, &Gtaw::kTraits, &Smaw::kTraits}) {
        double level = 0, pitch = 0;
        for (const float stretch : {0.0F, 0.35F, 0.7F, 1.0F}) {
            const std::vector<float> samples = soundOf(openArc(*process, stretch), 2);
            const std::span<const float> steady = std::span(samples).subspan(Sound::kRate / 2);
            INFO(process->name << ", stretch " << stretch << ": " << rootMeanSquare(steady) << ", "
                               << meanFrequency(steady) << " Hz");
            CHECK(rootMeanSquare(steady) > level);
            CHECK(meanFrequency(steady) > pitch);
            level = rootMeanSquare(steady);
            pitch = meanFrequency(steady);
        }
    }
}

TEST_CASE("drops hum at their rate: slow and large below the current of spray, fast above", "[sound]") {
    const ShieldingGas& mix = shieldingGas(GasKind::arCo2);
    const double globular = wireDropRate(1.0e-3, 0.1, 100, mix), spray = wireDropRate(1.0e-3, 0.2, 300, mix);
    CHECK(globular == Approx(1.5 * 0.1 / 8e-3));
    CHECK(spray == Approx(1.5 * 0.2 / 1e-3));
    SoundStep step = openArc(Gmaw::kTraits);
    step.dropRate = 300;
    const std::vector<float> with = soundOf(step, 1);
    CHECK(rootMeanSquare(with) > 2 * rootMeanSquare(soundOf(openArc(Gtaw::kTraits), 1)));
}

TEST_CASE("gas flows before the arc and after it, then there is silence to the last bit", "[sound]") {
    for (const ProcessTraits* process : {&Gmaw::kTraits, &Gtaw::kTraits}) {
        Sound sound;
        std::vector<float> before, burning, after, late;
        for (int i = 0; i < 45; ++i)
            append(before, sound, noArc(*process, 1));
        for (int i = 0; i < 90; ++i)
            append(burning, sound, openArc(*process));
        for (int i = 0; i < 30; ++i)
            append(after, sound, noArc(*process));
        for (int i = 0; i < 90 * 13; ++i)
            append(late, sound, noArc(*process));
        CHECK(rootMeanSquare(before) > 0.003);
        CHECK(rootMeanSquare(std::span(after).last(1000)) > 0.003);
        CHECK(rootMeanSquare(burning) > 2 * rootMeanSquare(std::span(after).last(1000)));
        CHECK(isSilent(std::span(late).last(Sound::kRate / 2)));
    }
    CHECK(isSilent(soundOf(noArc(Smaw::kTraits), 1)));
    CHECK(isSilent(soundOf(noArc(Flame::kTraits), 1)));
    SoundStep dry = noArc(Gmaw::kTraits, 1);
    dry.withoutGas = true;
    CHECK(isSilent(soundOf(dry, 1)));
}

TEST_CASE("a wire machine whose gas is off or not connected has no rush of gas", "[sound]") {
    ProcessSettings settings;
    auto& gmaw = settings.choose<Gmaw>();
    TorchSample torch;
    torch.trigger = 1;
    SoundSource source;
    const auto withoutGas = [&] {
        source.step(settings, {}, torch, 0.01, 0);
        return source.last().withoutGas;
    };
    CHECK_FALSE(withoutGas());
    gmaw.gasFlowLMin = 0;
    CHECK(withoutGas());
    gmaw.gasFlowLMin = 14;
    gmaw.gas = static_cast<int>(GasKind::none);
    CHECK(withoutGas());
    settings.choose<Gtaw>();
    CHECK_FALSE(withoutGas());
}

TEST_CASE("each thing that happens is heard: stub, scratch, flame, alternating current, ticks, hammer", "[sound]") {
    SoundStep touching = noArc(Smaw::kTraits, 1);
    touching.arc.noArc = NoArc::touching;
    touching.arc.distance = 0;
    CHECK(isSilent(soundOf(touching, 0.5)));
    touching.tipSpeed = 0.03F;
    CHECK(rootMeanSquare(soundOf(touching, 0.5)) > 0.01);

    SoundStep flame = noArc(Flame::kTraits, 1);
    CHECK(rootMeanSquare(soundOf(flame, 1)) > 0.05);
    CHECK(meanFrequency(soundOf(flame, 1)) < meanFrequency(soundOf(openArc(Gtaw::kTraits), 1)));

    CHECK(rootMeanSquare(soundOf(stubbedWire(), 1)) > 0.1);

    SoundStep alternating = openArc(Gtaw::kTraits);
    alternating.alternating = Gtaw::kTraits.alternating;
    CHECK(rootMeanSquare(soundOf(alternating, 1)) > 2 * rootMeanSquare(soundOf(openArc(Gtaw::kTraits), 1)));

    Sound cooling;
    std::vector<float> ticks;
    SoundStep hot = noArc(Smaw::kTraits);
    for (int i = 0; i < 900; ++i) { // change of 400 K in ten seconds
        hot.hottest = 1000 - 0.4F / 0.9F * static_cast<float>(i);
        append(ticks, cooling, hot);
    }
    CHECK(clicksIn(ticks, 0.02F, 0.03) == 15);

    Sound hammer;
    std::vector<float> strokes;
    SoundStep chipped = noArc(Smaw::kTraits);
    chipped.chips = 3;
    append(strokes, hammer, chipped);
    for (int i = 0; i < 180; ++i)
        append(strokes, hammer, noArc(Smaw::kTraits));
    CHECK(clicksIn(strokes, 0.25F, 0.2) == 3);
}

TEST_CASE("the same steps sound the same to the last bit, however they are read", "[sound]") {
    const auto run = [](size_t chunk) {
        Sound sound;
        ShortCircuits shorts;
        std::vector<float> samples;
        for (int i = 0; i < 300; ++i) {
            sound.begin(i < 100 ? openArc(Smaw::kTraits, 0.3F) : i < 200 ? shorting(shorts) : stubbedWire());
            while (sound.left() > 0) {
                std::vector<float> part(chunk);
                part.resize(sound.read(part));
                samples.insert(samples.end(), part.begin(), part.end());
            }
        }
        return samples;
    };
    const std::vector<float> whole = run(4096);
    CHECK(whole.size() == 160000);
    CHECK(whole == run(4096));
    CHECK(whole == run(7));
}

TEST_CASE("nothing clips, whatever sounds at once", "[sound]") {
    Sound sound;
    std::vector<float> samples;
    ShortCircuits shorts;
    for (int i = 0; i < 400; ++i) {
        SoundStep step = i % 3 == 0 ? stubbedWire() : shorting(shorts, 168);
        if (i % 50 == 0) step = noArc(Gmaw::kTraits); // repeated strikes
        step.arc.current = 600;
        step.arc.voltage = 60;
        for (ShortCircuit& each : step.shorts)
            each.power = 36000;
        step.chips = 1;
        step.alternating = 100;
        append(samples, sound, step);
    }
    CHECK(loudest(samples) > 0.7F);
    CHECK(loudest(samples) < 0.99F);
}

TEST_CASE("what the hand feels rises and falls with what is heard", "[sound]") {
    Sound sound;
    ShortCircuits shorts;
    std::vector<double> heard, felt;
    const auto play = [&](int steps, const std::function<SoundStep()>& make) {
        for (int i = 0; i < steps; i += 9) { // steps of a tenth of a second
            std::vector<float> samples;
            double amplitude = 0;
            for (int k = 0; k < 9; ++k) {
                const SoundStep step = make();
                append(samples, sound, step);
                TipFeel tip;
                tip.arc = step.arc;
                tip.shorts = step.shortPhase;
                tip.time = (i + k) * kSoundStep;
                amplitude += static_cast<double>(feel(tip).amplitude) / 9;
            }
            heard.push_back(rootMeanSquare(samples));
            felt.push_back(amplitude);
        }
    };
    const auto spray = [] {
        SoundStep step = openArc(Gmaw::kTraits, 0.1F);
        step.dropRate = 250;
        return step;
    };
    play(90, [] { return noArc(Gmaw::kTraits); });
    play(180, [&] { return shorting(shorts); });
    play(90, [] { return noArc(Gmaw::kTraits, 1); });
    play(180, spray);
    play(90, [] { return stubbedWire(); });
    play(90, [] { return noArc(Gmaw::kTraits); });
    play(90, [&] { return shorting(shorts, 60); });
    play(90, [] { return noArc(Gmaw::kTraits); });
    const double share = correlation(heard, felt);
    INFO(share);
    CHECK(share > 0.8);
}

TEST_CASE("ten seconds of each process: level, loudest sample and mean frequency", "[sound]") {
    struct Case {
        const char* name;
        SoundStep step;
    };
    SoundStep spray = openArc(Gmaw::kTraits, 0.1F);
    spray.dropRate = 250;
    SoundStep alternating = openArc(Gtaw::kTraits, 0.1F);
    alternating.alternating = Gtaw::kTraits.alternating;
    for (const Case& each : {Case{"GMAW, spray", spray}, Case{"GMAW, long arc", openArc(Gmaw::kTraits, 1)},
                             Case{"GTAW", openArc(Gtaw::kTraits, 0.1F)}, Case{"GTAW on aluminium", alternating},
                             Case{"SMAW", openArc(Smaw::kTraits, 0.1F)}, Case{"flame", noArc(Flame::kTraits, 1)},
                             Case{"GMAW, stubbed", stubbedWire()}}) {
        const std::vector<float> samples = soundOf(each.step, 10);
        WARN(each.name << ": level " << 20 * std::log10(rootMeanSquare(samples)) << " dB of full scale, loudest "
                       << loudest(samples) << ", mean frequency " << meanFrequency(samples) << " Hz");
        CHECK(rootMeanSquare(samples) > 0.01);
        CHECK(rootMeanSquare(samples) < 0.3);
    }
    Sound sound;
    ShortCircuits shorts;
    std::vector<float> samples;
    for (int i = 0; i < 900; ++i)
        append(samples, sound, shorting(shorts));
    WARN("GMAW, short arc: level " << 20 * std::log10(rootMeanSquare(samples)) << " dB of full scale, loudest "
                                   << loudest(samples) << ", mean frequency " << meanFrequency(samples) << " Hz, "
                                   << shorts.count() << " short circuits");
    CHECK(rootMeanSquare(samples) > 0.01);
}

TEST_CASE("a sound track keeps a run's samples as 16 bits", "[sound]") {
    SoundTrack track;
    for (int i = 0; i < 90; ++i)
        track.add(openArc(Smaw::kTraits, 0.5F));
    CHECK(track.samples().size() == Sound::kRate);
    CHECK(*std::max_element(track.samples().begin(), track.samples().end()) > 1000);
}
