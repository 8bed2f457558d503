// GPU time of named passes, read frames later so that the CPU does not wait.
#pragma once

#include "core/gl/gl.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meltpool::gl {

/// Times of one pass.
struct PassTime {
    std::string name;
    int depth = 0;      ///< nesting: 0 = top
    double lastMs = 0;  ///< the newest frame read
    double leastMs = 0; ///< minimum over all frames since reset()
    double totalMs = 0; ///< sum over all frames and executions of the pass since reset()
    int frames = 0;
};

class Profiler {
  public:
    Profiler() = default;
    ~Profiler();
    Profiler(const Profiler&) = delete;
    Profiler& operator=(const Profiler&) = delete;

    void beginFrame();
    void endFrame();
    bool inFrame() const { return inFrame_; } ///< true between beginFrame() and endFrame()
    /// Waits for the pending frames and reads them.
    void finish();
    void reset();

    /// Adds the newest times of passes that another context's profiler measured within the current frame.
    void include(const Profiler& other);

    const std::vector<PassTime>& passes() const { return passes_; }
    const PassTime* find(std::string_view name) const;

  private:
    friend class Scope;
    struct Mark {
        size_t pass = 0;
        GLuint begin = 0;
        GLuint end = 0;
    };
    struct Frame {
        std::vector<Mark> marks;
        std::vector<std::pair<size_t, double>> included; ///< pass, ms
        bool pending = false;
    };

    size_t passOf(std::string_view name, int depth);
    size_t open(std::string_view name);
    void close(size_t mark);
    void collect(Frame& frame, bool wait);
    void add(size_t pass, double ms);
    void closeFrame();
    GLuint takeQuery();

    bool inFrame_ = false;
    int depth_ = 0;
    size_t current_ = 0;
    std::array<Frame, 4> frames_;
    std::vector<GLuint> spare_;
    std::vector<PassTime> passes_;
    std::vector<double> frameMs_;
};

/// A debug group for the commands issued during its lifetime, timed if there is a profiler.
class Scope {
  public:
    Scope(Profiler* profiler, std::string_view name);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Profiler* profiler_;
    size_t mark_ = 0;
};

} // namespace meltpool::gl
