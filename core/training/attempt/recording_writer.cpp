#include "core/training/attempt/recording_writer.hpp"

#include "core/base/error.hpp"
#include "core/training/attempt/little_endian.hpp"

#include <system_error>
#include <utility>

namespace meltpool {

namespace {

template <class Bytes>
std::string_view viewOf(const Bytes& bytes) {
    return {bytes.data(), bytes.size()};
}

/// Bytes of `batch` up to the end of the last frame within its first `count`.
size_t wholeFrames(std::string_view batch, size_t count) {
    size_t whole = 0;
    while (whole + kFrameHeadBytes <= count) {
        ByteReader head(batch.substr(whole, kFrameHeadBytes));
        head.u32();
        const size_t next = whole + kFrameBytes + head.u32();
        if (next > count) break;
        whole = next;
    }
    return whole;
}

bool samePlaces(const RecordingPerson& a, const RecordingPerson& b) {
    return a.head == b.head && a.left == b.left && a.right == b.right && a.zoom == b.zoom;
}

bool isRedo(const RecordingFrame& frame) {
    return frame.is(FrameKind::event) && readNote(frame.content).name == "redo";
}

} // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const AttemptHead& head,
                                 const std::filesystem::path& begin)
    : file_(file) {
    batch_ = kRecordingSignature;
    appendFrame(batch_, chain_, static_cast<std::uint32_t>(FrameKind::head), headContent(head));
    try {
        if (!begin.empty()) copy(begin);
        if (!file_.append(batch_)) throw RuntimeFault(file.string() + ": cannot be written: " + file_.reason());
    } catch (...) {
        file_.remove();
        throw;
    }
    bytes_ = file_.written();
    batch_.clear();
    batch_.reserve(2 * kRoom); // frames are a little longer in the file
    look_ = Clock::now() + kLook;
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error& failure) {
        file_.remove();
        throw RuntimeFault(file.string() + ": the thread that writes cannot start: " + failure.what() +
                           "; expected a computer with room for another thread");
    }
}

/// Takes every frame between head and end of a finished recording.
void RecordingWriter::copy(const std::filesystem::path& begin) {
    FrameReader reader(begin);
    RecordingFrame frame;
    while (reader.next(frame)) {
        if (frame.is(FrameKind::head) || frame.is(FrameKind::end)) continue;
        if (isRedo(frame)) redone_.fetch_add(1, std::memory_order_relaxed);
        appendFrame(batch_, chain_, frame.kind, frame.content);
        if (batch_.size() < kRoom) continue;
        if (!file_.append(batch_)) throw RuntimeFault(file().string() + ": cannot be written: " + file_.reason());
        batch_.clear();
    }
    if (reader.ended() != FrameReader::Ended::whole)
        throw InputError(begin, 0, "is not whole; expected an attempt that has ended");
}

RecordingWriter::~RecordingWriter() {
    wait();
}

void RecordingWriter::put(FrameKind kind, std::initializer_list<std::string_view> parts) {
    if (ended_ || failed_.load(std::memory_order_relaxed) || overflowed_.load(std::memory_order_relaxed)) return;
    if (!ring_.put(static_cast<std::uint32_t>(kind), parts)) overflowed_.store(true, std::memory_order_release);
}

void RecordingWriter::step(const RecordingStep& step) {
    const auto content = stepContent(step);
    put(FrameKind::step, {viewOf(content)});
}

void RecordingWriter::person(const RecordingPerson& person) {
    if (personKnown_ && samePlaces(person, person_)) return;
    person_ = person;
    personKnown_ = true;
    const auto content = personContent(person);
    put(FrameKind::person, {viewOf(content)});
}

void RecordingWriter::change(std::uint64_t steps, std::string_view key, std::string_view value) {
    const auto head = noteHead(steps, key);
    put(FrameKind::change, {viewOf(head), key, value});
}

void RecordingWriter::event(std::uint64_t steps, std::string_view name, std::string_view value) {
    const auto head = noteHead(steps, name);
    put(FrameKind::event, {viewOf(head), name, value});
    if (name != "redo") return;
    personKnown_ = false; // person frames written since then are dropped
    redone_.fetch_add(1, std::memory_order_relaxed);
}

void RecordingWriter::checkpoint(std::uint64_t steps, std::vector<std::byte> bytes) {
    const std::lock_guard lock(mutex_);
    if (closing_ || failed_.load(std::memory_order_relaxed) || waiting_ + bytes.size() > kMostWaiting) return;
    waiting_ += bytes.size();
    checkpoints_.push_back({{steps, redone_.load(std::memory_order_relaxed)}, std::move(bytes)});
}

void RecordingWriter::judged(std::optional<double> score, std::string verdict) {
    score_ = score;
    verdict_ = std::move(verdict);
}

void RecordingWriter::end(RecordingEnd end) {
    if (ended_) return;
    end.score = score_;
    end.verdict = verdict_;
    end.redone = redone_;
    put(FrameKind::end, {endContent(end)});
    close();
}

void RecordingWriter::close() {
    ended_ = true;
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    changed_.notify_one();
}

void RecordingWriter::wait() {
    if (!ended_) close();
    if (thread_.joinable()) thread_.join();
}

const std::string& RecordingWriter::fault() const {
    static const std::string kNone;
    return failed_.load(std::memory_order_acquire) ? fault_ : kNone;
}

void RecordingWriter::fail(std::string sentence) {
    if (failed_.load(std::memory_order_relaxed)) return;
    fault_ = std::move(sentence);
    failed_.store(true, std::memory_order_release);
}

/// Runs on the writing thread.
void RecordingWriter::run() {
    bool closing = false;
    while (!closing && !failed_.load(std::memory_order_relaxed)) {
        {
            std::unique_lock lock(mutex_);
            changed_.wait_for(lock, kPeriod, [this] { return closing_; });
            closing = closing_;
        }
        const bool overflowed = overflowed_.load(std::memory_order_acquire); // read before the ring is emptied
        gather();
        if (!write() || !lookForFile(closing)) break;
        if (overflowed)
            fail(file().string() + ": the disk is too slow for the recording; expected one that takes 100 kB/s");
    }
    if (!file_.finish()) fail(file().string() + ": the recording cannot be saved to the disk: " + file_.reason());
    finished_.store(true, std::memory_order_release);
}

/// Seals everything that has arrived. A checkpoint may come before its own step or after later ones, but after the way
/// back that led to it, which entered the ring first, and before the end, which closes the file.
void RecordingWriter::gather() {
    std::vector<Checkpoint> checkpoints;
    {
        const std::lock_guard lock(mutex_);
        checkpoints.swap(checkpoints_);
        waiting_ = 0;
    }
    std::uint32_t kind = 0;
    while (ring_.take(kind, content_)) {
        if (kind == static_cast<std::uint32_t>(FrameKind::end)) appendCheckpoints(std::exchange(checkpoints, {}));
        appendFrame(batch_, chain_, kind, content_);
    }
    appendCheckpoints(checkpoints);
}

void RecordingWriter::appendCheckpoints(const std::vector<Checkpoint>& checkpoints) {
    std::string content;
    for (const auto& [head, bytes] : checkpoints) {
        const auto start = checkpointHead(head);
        content.assign(start.data(), start.size());
        content.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        appendFrame(batch_, chain_, static_cast<std::uint32_t>(FrameKind::checkpoint), content);
    }
}

/// Writes the batch. On a full disk it cuts the file to whole frames.
bool RecordingWriter::write() {
    const std::uint64_t before = file_.written();
    const bool good = batch_.empty() || file_.append(batch_);
    if (!good) {
        fail(file().string() + ": the recording cannot be continued: " + file_.reason());
        file_.cut(before + wholeFrames(batch_, static_cast<size_t>(file_.written() - before)));
    }
    bytes_.store(file_.written(), std::memory_order_relaxed);
    batch_.clear();
    return good;
}

/// A file that lost its name still takes everything and disappears when it is closed.
bool RecordingWriter::lookForFile(bool now) {
    if (!now && Clock::now() < look_) return true;
    look_ = Clock::now() + kLook;
    if (file_.there()) return true;
    fail(file().string() + ": the recording is no longer there; expected its folder to stay while a weld runs");
    return false;
}

} // namespace meltpool
