#include "app/session/messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meltpool {

namespace {

constexpr size_t kMostMessages = 5;
constexpr double kNoteSeconds = 5;
constexpr double kWarningSeconds = 20;

} // namespace

void Messages::note(std::string text, double now, std::string topic) {
    add({Message::Kind::note, std::move(text), now + kNoteSeconds, std::move(topic)});
}

void Messages::warn(std::string text, double now, std::string topic) {
    add({Message::Kind::warning, std::move(text), now + kWarningSeconds, std::move(topic)});
}

void Messages::hold(std::string_view text, std::string_view topic) {
    const auto dismissed = dismissed_.find(topic);
    if (dismissed != dismissed_.end() && dismissed->second == text) return;
    for (Message& m : shown_) {
        if (m.topic != topic || !std::isinf(m.until)) continue;
        if (m.text != text) m.text.assign(text); // assigns in place: a text that fits the capacity allocates nothing
        return;
    }
    add({Message::Kind::warning, std::string(text), std::numeric_limits<double>::infinity(), std::string(topic)});
}

void Messages::dismiss(const Message& message) {
    if (std::isinf(message.until)) dismissed_[message.topic] = message.text;
    std::erase_if(shown_, [&](const Message& m) { return &m == &message; });
}

void Messages::clear(std::string_view topic) {
    if (const auto dismissed = dismissed_.find(topic); dismissed != dismissed_.end()) dismissed_.erase(dismissed);
    take(topic);
}

void Messages::take(std::string_view topic) {
    std::erase_if(shown_, [&](const Message& m) { return m.topic == topic; });
}

void Messages::expire(double now) {
    std::erase_if(shown_, [now](const Message& m) { return m.until <= now; });
}

void Messages::add(Message message) {
    if (!message.topic.empty()) take(message.topic);
    shown_.push_back(std::move(message));
    if (shown_.size() > kMostMessages) shown_.pop_front();
}

} // namespace meltpool
