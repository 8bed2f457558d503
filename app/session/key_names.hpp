// The letters that are printed on the keys of the keyboard that is there.
#pragma once

#include "app/session/input.hpp"
#include "core/base/function_ref.hpp"

#include <array>
#include <string>
#include <string_view>

namespace meltpool {

/// Keys are known by their place: Key::w is the key above Key::s, on a French keyboard the one with the letter Z.
class KeyNames {
  public:
    /// Those of a US keyboard.
    KeyNames();

    /// `signOf` answers the sign (UTF-8) that a letter key types without other keys; empty: unknown, and the key keeps
    /// the name that it has on a US keyboard.
    void read(FunctionRef<std::string(Key)> signOf);

    /// "W"; of one of the letter keys, Key::a to Key::x.
    std::string_view of(Key key) const { return names_[static_cast<size_t>(key)]; }

    static const KeyNames& usual();

  private:
    static constexpr size_t kLetters = static_cast<size_t>(Key::left);
    std::array<std::string, kLetters> names_;
};

/// The letter as keys show it: "z" gives "Z", "я" gives "Я"; Latin, Greek and Cyrillic.
std::string capitalLetter(std::string_view sign);

} // namespace meltpool
