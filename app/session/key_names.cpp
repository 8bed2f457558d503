#include "app/session/key_names.hpp"

namespace meltpool {

namespace {

constexpr std::array<char, 16> kUsual{'A', 'C', 'D', 'E', 'F', 'G', 'H', 'J', 'K', 'N', 'Q', 'R', 'S', 'V', 'W', 'X'};
static_assert(kUsual.size() == static_cast<size_t>(Key::left));

/// Capital of a letter below U+0800.
unsigned capital(unsigned letter) {
    const auto within = [letter](unsigned low, unsigned high) { return letter >= low && letter <= high; };
    if (within('a', 'z')) return letter - 0x20;
    if (within(0xE0, 0xFE) && letter != 0xF7) return letter - 0x20;
    if (letter == 0x131) return 'I';
    const bool oddIsSmall = within(0x100, 0x137) || within(0x14A, 0x177);
    const bool evenIsSmall = within(0x139, 0x148) || within(0x179, 0x17E);
    if ((oddIsSmall && letter % 2 == 1) || (evenIsSmall && letter % 2 == 0)) return letter - 1;
    if (within(0x3B1, 0x3C9) && letter != 0x3C2) return letter - 0x20;
    if (within(0x430, 0x44F)) return letter - 0x20;
    if (within(0x450, 0x45F)) return letter - 0x50;
    return letter;
}

} // namespace

KeyNames::KeyNames() {
    for (size_t i = 0; i < kLetters; ++i)
        names_[i] = kUsual[i];
}

void KeyNames::read(FunctionRef<std::string(Key)> signOf) {
    for (size_t i = 0; i < kLetters; ++i) {
        const std::string sign = signOf(static_cast<Key>(i));
        names_[i] = sign.empty() ? std::string(1, kUsual[i]) : capitalLetter(sign);
    }
}

const KeyNames& KeyNames::usual() {
    static const KeyNames names;
    return names;
}

std::string capitalLetter(std::string_view sign) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(sign[i]); };
    if (sign.size() == 1) return std::string(1, static_cast<char>(byte(0) < 0x80 ? capital(byte(0)) : byte(0)));
    const bool two = sign.size() == 2 && (byte(0) & 0xE0) == 0xC0 && (byte(1) & 0xC0) == 0x80;
    if (!two) return std::string(sign);
    const unsigned letter = capital((byte(0) & 0x1Fu) << 6 | (byte(1) & 0x3Fu));
    if (letter < 0x80) return std::string(1, static_cast<char>(letter));
    return {static_cast<char>(0xC0 | letter >> 6), static_cast<char>(0x80 | (letter & 0x3F))};
}

} // namespace meltpool
