// A written or recorded path of the torch, with its pose at any time.
#pragma once

#include "core/weld/torch/torch_csv.hpp"
#include "core/weld/torch/torch_moves.hpp"

namespace meltpool {

/// Swings across the seam.
struct Weave {
    double width = 0;     ///< m from toe to toe
    double frequency = 0; ///< whole swings a second
    double dwell = 0;     ///< s at each toe
};

class TorchPath {
  public:
    TorchPath() = default;
    explicit TorchPath(std::vector<TorchSample> samples) : samples_(std::move(samples)) {}
    explicit TorchPath(std::vector<TorchMove> moves) : moves_(std::move(moves)) {}

    /// Reads the recorded form (isTorchTable()) or the authored form (.toml). Throws InputError for any other ending
    /// and for everything that readTorchCsv() and readTorchMoves() refuse.
    static TorchPath read(const std::filesystem::path& file);

    /// Returns the torch at `time` s. Recorded: place linear and orientation slerp between rows, a row's trigger and
    /// rod_feed until the next row; likewise a rod, which is there until the next row even if that has none. Before the
    /// first and after the last moment the torch is at that row's pose with the trigger released. Between a seen row
    /// and an unseen one it stays at the former's place.
    TorchSample sample(double time) const;

    /// Returns the mirror image of this path about the plane x = `middle` (m): torch, rod and their directions.
    TorchPath mirrored(double middle) const;

    /// Returns the time of the first pull of the trigger, s, to kTriggerGrain; nothing if it is never pulled.
    std::optional<double> firstPull() const;
    static constexpr double kTriggerGrain = 0.05; ///< s

    /// Returns the first weave of the authored form; nothing for a path without one and for the recorded form.
    std::optional<Weave> weave() const;

    /// Returns the hold of the rod in the authored form; nothing for a path without one and for the recorded form.
    std::optional<RodHold> rod() const;

    /// Returns the time of the last moment, s; 0 for an empty path.
    double duration() const;
    /// Returns the samples of the recorded form, as they were read; empty for the authored one.
    const std::vector<TorchSample>& samples() const { return samples_; }
    /// Returns the form of the table; nothing for the authored form and for a path that was not read from a file.
    const std::optional<TorchForm>& form() const { return form_; }
    /// Returns the radius of the pipe on whose face an authored path is written, m; 0: on none.
    double pipeRadius() const { return moves_.empty() ? 0 : moves_.front().pipeRadius; }
    bool empty() const { return samples_.empty() && moves_.empty(); }

  private:
    TorchSample sampleRecording(double time) const;
    TorchSample sampleMoves(double time) const;
    void place(TorchSample& sample) const;

    std::vector<TorchSample> samples_;
    std::vector<TorchMove> moves_;
    std::optional<TorchForm> form_;
    bool mirrored_ = false;
    float shift_ = 0; ///< m, added to x after the mirroring about x = 0
};

} // namespace meltpool
