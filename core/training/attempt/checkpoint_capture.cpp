#include "core/training/attempt/checkpoint_capture.hpp"

namespace meltpool {

namespace {

// More parts than any lesson has, so that a frame allocates nothing.
constexpr size_t kParts = 256;
constexpr size_t kNumbers = size_t(1) << 16; // bytes
constexpr size_t kHistory = size_t(1) << 18; // bytes: half a minute of steps

} // namespace

CheckpointCapture::CheckpointCapture() : parts_(&capture_.begin()) {
    parts_->parts.reserve(kParts);
    parts_->regions.reserve(kParts);
    parts_->numbers.reserve(kNumbers);
    head_.history.reserve(kHistory);
}

Checkpoint& CheckpointCapture::begin() {
    parts_ = &capture_.begin();
    head_.history.clear();
    return head_;
}

void CheckpointCapture::take(Checkpoint& checkpoint) const {
    checkpoint.step = head_.step;
    checkpoint.time = head_.time;
    checkpoint.identity = head_.identity;
    checkpoint.historyFrom = head_.historyFrom;
    checkpoint.historyTo = head_.historyTo;
    checkpoint.historyTime = head_.historyTime;
    checkpoint.history = head_.history;
    capture_.assemble(checkpoint.bytes, checkpoint.parts);
    seal(checkpoint);
}

} // namespace meltpool
