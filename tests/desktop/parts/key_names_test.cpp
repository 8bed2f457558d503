// Tests the names of the letter keys on keyboards of other layouts, by a lookup in place of the keyboard.
#include "app/session/key_names.hpp"
#include "tests/support/catch.hpp"

#include <map>

namespace meltpool::test {

TEST_CASE("keys are named as a French, a German, a Dvorak and a Russian keyboard show them") {
    const auto named = [](const std::map<Key, std::string>& signs) {
        KeyNames names;
        names.read([&](Key key) {
            const auto found = signs.find(key);
            return found == signs.end() ? std::string() : found->second;
        });
        return names;
    };
    const KeyNames french = named({{Key::w, "z"}, {Key::a, "q"}, {Key::q, "a"}, {Key::s, "s"}});
    CHECK(french.of(Key::w) == "Z");
    CHECK(french.of(Key::a) == "Q");
    CHECK(french.of(Key::q) == "A");
    CHECK(french.of(Key::s) == "S");
    CHECK(french.of(Key::d) == "D"); // unknown, so named as on a US keyboard
    const KeyNames dvorak = named({{Key::w, ","}, {Key::q, "'"}, {Key::h, "d"}});
    CHECK(dvorak.of(Key::w) == ",");
    CHECK(dvorak.of(Key::q) == "'");
    CHECK(dvorak.of(Key::h) == "D");
    const KeyNames russian = named({{Key::w, "ц"}, {Key::x, "ч"}});
    CHECK(russian.of(Key::w) == "Ц");
    CHECK(russian.of(Key::x) == "Ч");
    CHECK(KeyNames::usual().of(Key::x) == "X");
}

TEST_CASE("a layout that changes while the program runs leaves no name of the old one") {
    KeyNames names;
    names.read([](Key) { return std::string("ж"); });
    CHECK(names.of(Key::v) == "Ж");
    names.read([](Key) { return std::string(); });
    CHECK(names.of(Key::v) == "V");
}

TEST_CASE("small letters of Latin, Greek and Cyrillic become capital ones, other signs stay") {
    for (const auto& [small, capital] : std::map<std::string, std::string>{{"é", "É"},
                                                                           {"ÿ", "ÿ"},
                                                                           {"ß", "ß"},
                                                                           {"ş", "Ş"},
                                                                           {"ı", "I"},
                                                                           {"ž", "Ž"},
                                                                           {"ł", "Ł"},
                                                                           {"ω", "Ω"},
                                                                           {"ς", "ς"},
                                                                           {"ё", "Ё"},
                                                                           {"ї", "Ї"},
                                                                           {"я", "Я"},
                                                                           {"÷", "÷"},
                                                                           {";", ";"},
                                                                           {"ệ", "ệ"},
                                                                           {"ا", "ا"},
                                                                           {"", ""}})
        CHECK(capitalLetter(small) == capital);
}

} // namespace meltpool::test
