#include "core/gl/profiler.hpp"

#include <algorithm>

namespace meltpool::gl {

Profiler::~Profiler() {
    for (const Frame& frame : frames_)
        for (const Mark& mark : frame.marks) {
            spare_.push_back(mark.begin);
            spare_.push_back(mark.end);
        }
    if (!spare_.empty()) glDeleteQueries(GLsizei(spare_.size()), spare_.data());
}

void Profiler::beginFrame() {
    current_ = (current_ + 1) % frames_.size();
    collect(frames_[current_], true); // the frame is four frames old: its result has arrived
    inFrame_ = true;
}

void Profiler::endFrame() {
    inFrame_ = false;
    frames_[current_].pending = true;
    for (size_t age = 1; age < frames_.size(); ++age)
        collect(frames_[(current_ + age) % frames_.size()], false);
}

void Profiler::finish() {
    for (size_t age = 1; age <= frames_.size(); ++age)
        collect(frames_[(current_ + age) % frames_.size()], true);
}

void Profiler::reset() {
    finish();
    passes_.clear();
    frameMs_.clear();
}

const PassTime* Profiler::find(std::string_view name) const {
    const auto found =
        std::find_if(passes_.begin(), passes_.end(), [name](const PassTime& p) { return p.name == name; });
    return found == passes_.end() ? nullptr : &*found;
}

void Profiler::include(const Profiler& other) {
    if (!inFrame_) return;
    for (const PassTime& pass : other.passes_)
        frames_[current_].included.emplace_back(passOf(pass.name, depth_ + pass.depth), pass.lastMs);
}

/// The pass's number; adds a pass of this depth if it is new.
size_t Profiler::passOf(std::string_view name, int depth) {
    auto found = std::find_if(passes_.begin(), passes_.end(), [name](const PassTime& p) { return p.name == name; });
    if (found == passes_.end()) found = passes_.insert(found, PassTime{std::string(name), depth});
    return static_cast<size_t>(found - passes_.begin());
}

size_t Profiler::open(std::string_view name) {
    const size_t pass = passOf(name, depth_);
    ++depth_;
    const Mark mark{pass, takeQuery(), takeQuery()};
    glQueryCounter(mark.begin, GL_TIMESTAMP);
    frames_[current_].marks.push_back(mark);
    return frames_[current_].marks.size() - 1;
}

void Profiler::close(size_t index) {
    --depth_;
    glQueryCounter(frames_[current_].marks[index].end, GL_TIMESTAMP);
}

void Profiler::collect(Frame& frame, bool wait) {
    if (!frame.pending) return;
    if (!wait) {
        for (const Mark& mark : frame.marks) {
            GLint ready = GL_FALSE;
            glGetQueryObjectiv(mark.end, GL_QUERY_RESULT_AVAILABLE, &ready);
            if (ready == GL_FALSE) return;
        }
    }
    frameMs_.assign(passes_.size(), -1.0);
    for (const Mark& mark : frame.marks) {
        GLuint64 begin = 0, end = 0;
        glGetQueryObjectui64v(mark.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(mark.end, GL_QUERY_RESULT, &end);
        frameMs_[mark.pass] = std::max(frameMs_[mark.pass], 0.0) + double(end - begin) * 1e-6;
        spare_.push_back(mark.begin);
        spare_.push_back(mark.end);
    }
    for (const auto& [pass, ms] : frame.included)
        frameMs_[pass] = std::max(frameMs_[pass], 0.0) + ms;
    frame.marks.clear();
    frame.included.clear();
    frame.pending = false;
    closeFrame();
}

void Profiler::closeFrame() {
    for (size_t pass = 0; pass < frameMs_.size(); ++pass)
        if (frameMs_[pass] >= 0) add(pass, frameMs_[pass]);
}

void Profiler::add(size_t pass, double ms) {
    PassTime& time = passes_[pass];
    time.lastMs = ms;
    time.leastMs = time.frames == 0 ? ms : std::min(time.leastMs, ms);
    time.totalMs += ms;
    ++time.frames;
}

GLuint Profiler::takeQuery() {
    if (spare_.empty()) {
        spare_.resize(32);
        glCreateQueries(GL_TIMESTAMP, GLsizei(spare_.size()), spare_.data());
    }
    const GLuint query = spare_.back();
    spare_.pop_back();
    return query;
}

Scope::Scope(Profiler* profiler, std::string_view name)
    : profiler_(profiler != nullptr && profiler->inFrame_ ? profiler : nullptr) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
    if (profiler_ != nullptr) mark_ = profiler_->open(name);
}

Scope::~Scope() {
    if (profiler_ != nullptr) profiler_->close(mark_);
    glPopDebugGroup();
}

} // namespace meltpool::gl
