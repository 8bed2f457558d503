// Letters printed on the keys of the connected keyboard.
#pragma once

#include "app/session/input.hpp"
#include "core/base/function_ref.hpp"

#include <array>
#include <string>
#include <string_view>

namespace meltpool {

/// Names of keys. A key is known by its place: Key::w is the key above Key::s, on a French keyboard the one with the
/// letter Z.
class KeyNames {
  public:
    /// Starts with the names of a US keyboard.
    KeyNames();

    /// Reads the names. `signOf` returns the sign (UTF-8) that a letter key types without modifiers; empty: unknown,
    /// and the key keeps its US name.
    void read(FunctionRef<std::string(Key)> signOf);

    /// Name of a letter key, Key::a to Key::x: "W".
    std::string_view of(Key key) const { return names_[static_cast<size_t>(key)]; }

    static const KeyNames& usual();

  private:
    static constexpr size_t kLetters = static_cast<size_t>(Key::left);
    std::array<std::string, kLetters> names_;
};

/// Letter as printed on keys: "z" gives "Z", "я" gives "Я"; Latin, Greek and Cyrillic.
std::string capitalLetter(std::string_view sign);

} // namespace meltpool
