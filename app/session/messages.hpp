// Short messages that stay on the screen for a while: settings ignored, a shader that failed, a picture saved.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <string_view>

namespace meltpool {

struct Message {
    enum class Kind { note, warning };
    Kind kind = Kind::note;
    std::string text;
    double until = 0;  ///< s on the program's clock; infinite: until clear() or dismiss()
    std::string topic; ///< a newer message of the same topic replaces the older; "" never replaces
};

/// Topic of the message that the metal is slower than the clock.
inline constexpr std::string_view kSlowTopic = "slow";
/// Topic of the message on what the person at the desk did, which the person in the headset reads too.
inline constexpr std::string_view kDeskTopic = "desk did";

class Messages {
  public:
    /// Shows a text. `now`: s on the program's clock.
    void note(std::string text, double now, std::string topic = {});
    void warn(std::string text, double now, std::string topic = {});
    /// Shows a warning until clear(topic), for a fault that persists.
    void hold(std::string_view text, std::string_view topic);
    void clear(std::string_view topic);
    /// Hides one of shown(). A held one stays hidden until its text changes or clear() is called.
    void dismiss(const Message& message);

    /// Removes messages whose time is over.
    void expire(double now);
    const std::deque<Message>& shown() const { return shown_; }

  private:
    void add(Message message);
    void take(std::string_view topic);
    std::deque<Message> shown_;
    std::map<std::string, std::string, std::less<>>
        dismissed_; ///< topic and text of held messages that the person dismissed
};

} // namespace meltpool
