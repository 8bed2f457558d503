// The parts of the benchmark's suites; each has a file of its own.
#pragma once

namespace meltpool {

class Bench;
struct BenchRow;

void benchClassicMetal(Bench& bench);
void benchClassicThesis(Bench& bench);
void benchClassicFrame(Bench& bench);
void benchClassicSurface(Bench& bench);
void benchWeldMetal(Bench& bench);
void benchWeldSurface(Bench& bench);
void benchEmptyDispatches(Bench& bench);
void benchLesson(Bench& bench);
void benchCheckpoint(Bench& bench);
void benchRecording(Bench& bench);
void benchStereo(Bench& bench);
void benchHeadsetFrame(Bench& bench);
void benchLooks(Bench& bench);
void benchCard(Bench& bench);

/// Row of benchEmptyDispatches(): wall time of all of them, and by the GPU timer under `passes`.
BenchRow measureEmptyDispatches(Bench& bench);

} // namespace meltpool
