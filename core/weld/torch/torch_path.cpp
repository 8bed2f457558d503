#include "core/weld/torch/torch_path.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>

namespace meltpool {

namespace {

/// Mirrors a rotation about a plane of constant x: the reflected axis and the opposite angle.
glm::quat mirroredTurn(const glm::quat& turn) {
    return {turn.w, turn.x, -turn.y, -turn.z};
}

} // namespace

TorchPath TorchPath::read(const std::filesystem::path& file) {
    if (isTorchTable(file)) {
        TorchRecording recording = readTorchCsv(file, FurtherColumns::dropped);
        TorchPath path(std::move(recording.samples));
        path.form_ = recording.form;
        return path;
    }
    if (lowerExtension(file) == ".toml") return TorchPath(readTorchMoves(file));
    throw InputError(file, 0,
                     "is no torch path; expected a file that ends in .csv, .tsv or .txt (recorded) or in .toml "
                     "(authored)");
}

double TorchPath::duration() const {
    if (!samples_.empty()) return samples_.back().time;
    return moves_.empty() ? 0 : moves_.back().begin + moves_.back().duration;
}

void TorchPath::place(TorchSample& sample) const {
    const float sign = mirrored_ ? -1.0f : 1.0f;
    sample.tip.x = sign * sample.tip.x + shift_;
    if (sample.rod) sample.rod->tip.x = sign * sample.rod->tip.x + shift_;
    if (!mirrored_) return;
    sample.orientation = mirroredTurn(sample.orientation);
    if (sample.rod) sample.rod->orientation = mirroredTurn(sample.rod->orientation);
}

TorchPath TorchPath::mirrored(double middle) const {
    TorchPath image = *this;
    image.mirrored_ = !mirrored_;
    image.shift_ = static_cast<float>(2 * middle) - shift_;
    return image;
}

std::optional<double> TorchPath::firstPull() const {
    for (double time = 0; time < duration(); time += kTriggerGrain)
        if (sample(time).trigger > 0) return time;
    return std::nullopt;
}

std::optional<Weave> TorchPath::weave() const {
    for (const TorchMove& move : moves_)
        if (move.weaveHalfSwings > 0)
            return Weave{move.weaveWidth, move.weaveHalfSwings / (2 * move.duration), move.weaveDwell};
    return std::nullopt;
}

std::optional<RodHold> TorchPath::rod() const {
    for (const TorchMove& move : moves_)
        if (move.rod) return move.rod;
    return std::nullopt;
}

TorchSample TorchPath::sample(double time) const {
    TorchSample result;
    result.time = time;
    if (!samples_.empty()) result = sampleRecording(time);
    if (samples_.empty() && !moves_.empty()) result = sampleMoves(time);
    if (mirrored_ || shift_ != 0) place(result);
    return result;
}

TorchSample TorchPath::sampleRecording(double time) const {
    const auto next = std::upper_bound(samples_.begin(), samples_.end(), time,
                                       [](double t, const TorchSample& s) { return t < s.time; });
    const bool before = next == samples_.begin();
    TorchSample result = before ? samples_.front() : *(next - 1);
    const bool over = next == samples_.end() && time > samples_.back().time;
    if (before || over) result.trigger = 0;
    if (!before && next != samples_.end()) {
        const TorchSample& last = *(next - 1);
        const auto share = static_cast<float>((time - last.time) / (next->time - last.time));
        // A row's own moment returns its own bits; between a seen and an unseen moment nothing is interpolated.
        if (share > 0 && last.seen && next->seen) {
            result.tip = glm::mix(last.tip, next->tip, share);
            result.orientation = glm::normalize(glm::slerp(last.orientation, next->orientation, share));
            if (last.rod && next->rod) {
                result.rod->tip = glm::mix(last.rod->tip, next->rod->tip, share);
                result.rod->orientation =
                    glm::normalize(glm::slerp(last.rod->orientation, next->rod->orientation, share));
            }
        }
    }
    result.time = time;
    return result;
}

TorchSample TorchPath::sampleMoves(double time) const {
    const auto next =
        std::upper_bound(moves_.begin(), moves_.end(), time, [](double t, const TorchMove& m) { return t < m.begin; });
    const TorchMove& move = next == moves_.begin() ? *next : *(next - 1);
    TorchSample result = move.sample(std::clamp(time, move.begin, move.begin + move.duration));
    if (time < 0 || time > duration()) result.trigger = 0;
    result.time = time;
    return result;
}

} // namespace meltpool
