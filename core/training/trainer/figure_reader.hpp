// Reads the metal's figures back from the GPU without keeping its steps waiting, and gives each row of a record its
// own.
#pragma once

#include "core/training/trainer/attempt_recorder.hpp"
#include "core/training/trainer/lesson_metal.hpp"

#include <cstddef>

namespace meltpool {

class FigureReader {
  public:
    /// Both must outlive this.
    FigureReader(LessonMetal& metal, AttemptRecorder& recorder);

    /// True: each update() waits for the figures of its own step. False (the default): it takes the newest that have
    /// come, asked for ten times in a simulated second, or for each step while a CSV record is written.
    void setWaiting(bool wait) { wait_ = wait; }

    /// After a step that ended at `time` (simulated s).
    void update(double time);
    /// Waits until no answer is pending.
    void finish() { await(0); }
    const MetalStatistics& newest() const { return newest_; }

    /// The metal is another one: its figures are read at once, which waits for the GPU.
    void readAgain();
    /// The same at the start of an attempt.
    void reset();
    void transfer(gl::StateArchive& archive); ///< saves or restores when figures are due

  private:
    void take(const MetalStatistics& figures);
    void await(size_t left);

    LessonMetal& metal_;
    AttemptRecorder& recorder_;
    MetalStatistics newest_;
    bool wait_ = false;
    size_t asked_ = 0; ///< answers that are still to come
    double next_ = 0;  ///< simulated time from which they are asked for again, s
};

} // namespace meltpool
