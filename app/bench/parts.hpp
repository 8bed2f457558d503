// The parts of which the benchmark's suites are made; each stands in a file of its own.
#pragma once

namespace meltpool {

class Bench;

void benchClassicMetal(Bench& bench);
void benchClassicThesis(Bench& bench);
void benchClassicFrame(Bench& bench);
void benchClassicSurface(Bench& bench);
void benchWeldMetal(Bench& bench);
void benchWeldSurface(Bench& bench);
void benchStereo(Bench& bench);
void benchHeadsetFrame(Bench& bench);

} // namespace meltpool
