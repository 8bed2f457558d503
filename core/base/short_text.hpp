// Text of bounded length that allocates nothing, for labels that are built in every frame.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

namespace meltpool {

/// A text in a fixed buffer; cuts longer text.
class ShortText {
  public:
    ShortText() = default;
    ShortText(std::initializer_list<std::string_view> parts) {
        for (const std::string_view part : parts)
            *this += part;
    }
    ShortText(std::string_view text) { *this += text; }
    ShortText(const char* text) { *this += text; }
    ShortText(const std::string& text) { *this += text; }

    ShortText& operator+=(std::string_view part) {
        const size_t fits = std::min(part.size(), text_.size() - 1 - length_);
        std::memcpy(text_.data() + length_, part.data(), fits);
        length_ += fits;
        text_[length_] = 0;
        return *this;
    }
    /// Appends the shortest text that reads back as `number`, in the form of formatNumber().
    ShortText& addNumber(double number) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
        return *this += std::string_view(digits.data(), end.ptr);
    }
    void cutTo(size_t length) {
        length_ = std::min(length, length_);
        text_[length_] = 0;
    }

    const char* c_str() const { return text_.data(); }
    char* data() { return text_.data(); }
    size_t size() const { return length_; }
    bool empty() const { return length_ == 0; }
    operator std::string_view() const { return {text_.data(), length_}; }

  private:
    std::array<char, 240> text_{};
    size_t length_ = 0;
};

} // namespace meltpool
