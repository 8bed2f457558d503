#include "app/bench/parts.hpp"

#include "app/bench/bench.hpp"

#include <array>

namespace meltpool {

std::span<const BenchPart> benchParts() {
    static constexpr std::array kParts{
        BenchPart{"classic",
                  "step: 8192 to 1048576 liquid particles with 30 neighbours each, all pairs for the two small",
                  benchClassicMetal},
        BenchPart{"classic", "step with the thesis's values, a corner of the cube liquid", benchClassicThesis},
        BenchPart{"classic", "whole frame: step, surface and picture at 8192 particles, grid 64, 1280x720",
                  benchClassicFrame},
        BenchPart{"classic", "surface alone: grid 32, 64 and 128", benchClassicSurface},
        BenchPart{"weld", "frame of a GMAW bead on a plate of 100x50x6 mm and on one of four times the area: the metal",
                  benchWeldMetal},
        BenchPart{"weld", "surface around a moving pool in a plate of 100x50x6 mm and in one of four times the area",
                  benchWeldSurface},
        BenchPart{"weld", "200 empty indirect dispatches with barrier: cost of passes without work",
                  benchEmptyDispatches},
        BenchPart{"lesson", "the lesson gmaw-bead with surface and thirty pictures of 1280x720 a simulated second",
                  benchLesson},
        BenchPart{"lesson", "the lesson gmaw-bead after 4 s: its whole state saved, packed, unpacked and restored",
                  benchCheckpoint},
        BenchPart{"lesson", "the lesson gmaw-bead recorded with moments of its metal, over the same without",
                  benchRecording},
        BenchPart{"stereo", "both eyes of a headset over one, in three ways: 672x756 pixels an eye, 4 samples",
                  benchStereo},
        BenchPart{"stereo", "the processor's own work for a headset's frame, and with a headset where there is one",
                  benchHeadsetFrame},
        BenchPart{"looks",
                  "one moment of gmaw-bead, 1280x720: each level of detail and each measure of it, one eye and two",
                  benchLooks},
        BenchPart{"card",
                  "two minutes on a graphics card: price of a pass, substep by pool size, gmaw-bead at 1 and 0.5 mm, "
                  "both eyes of 2064x2208",
                  benchCard},
    };
    return kParts;
}

} // namespace meltpool
