// Reads the metal's figures back from the GPU without delaying its steps, and gives each row of a record its own.
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
    /// arrived, requested ten times in a simulated second, or for each step while a CSV record is written.
    void setWaiting(bool wait) { wait_ = wait; }

    /// Call it after a step that ended at `time` (simulated s).
    void update(double time);
    /// Waits until no answer is pending.
    void finish() { await(0); }
    const MetalStatistics& newest() const { return newest_; }

    /// Call it after the metal was replaced: reads its figures at once, which waits for the GPU.
    void readAgain();
    /// Call it at the start of an attempt: reads the figures at once, which waits for the GPU.
    void reset();
    void transfer(gl::StateArchive& archive); ///< saves or restores the next time of reading

  private:
    void take(const MetalStatistics& figures);
    void await(size_t left);

    LessonMetal& metal_;
    AttemptRecorder& recorder_;
    MetalStatistics newest_;
    bool wait_ = false;
    size_t asked_ = 0; ///< pending answers
    double next_ = 0;  ///< simulated time of the next request, s
};

} // namespace meltpool
