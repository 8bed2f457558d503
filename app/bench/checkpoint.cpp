// The cost of a checkpoint: saving the whole state of a weld, packing it and going back to it, and its size in bytes.
#include "app/bench/bench.hpp"
#include "app/bench/parts.hpp"
#include "core/base/resources.hpp"
#include "core/training/attempt/packing.hpp"
#include "core/training/trainer/trainer.hpp"

namespace meltpool {

namespace {

constexpr double kWelded = 4;    ///< s of the demonstration
constexpr double kReference = 3; ///< s, time of the earlier checkpoint that it is packed against

void weldUntil(Trainer& trainer, double time) {
    while (trainer.time() < time)
        trainer.advanceDemonstration(nullptr);
}

} // namespace

void benchCheckpoint(Bench& bench) {
    Trainer trainer(bench.shaders(), findLesson("gmaw-bead", resourceFolder() / "data" / "lessons"));
    const Checkpoint start = trainer.save();
    weldUntil(trainer, kReference);
    const Checkpoint before = trainer.save();
    weldUntil(trainer, kWelded);
    const size_t particles = trainer.result().metal.particles;
    Checkpoint saved, back;
    std::vector<std::byte> packed;
    const auto add = [&](std::string what, const std::function<void()>& work, const size_t& bytes) {
        BenchRow row = bench.measure(std::move(what), [&](gl::Profiler&) { work(); });
        row.particles = particles;
        row.bytes = bytes;
        bench.add(std::move(row));
    };
    size_t bytes = 0;
    add(
        "state saved",
        [&] {
            saved = trainer.save(before.historyTo);
            bytes = saved.bytes.size();
        },
        bytes);
    const auto packAgainst = [&](const Checkpoint& reference) {
        packed = pack(saved, reference);
        bytes = packed.size();
    };
    add(
        "state packed, a second after its reference", [&] { packAgainst(before); }, bytes);
    add(
        "state packed against the start", [&] { packAgainst(start); }, bytes);
    add(
        "state unpacked", [&] { back = unpack(packed, start); }, bytes);
    add(
        "state restored", [&] { trainer.restore(back); }, bytes);
}

} // namespace meltpool
