// Tests lengths in millimetres and inches: numbers, sentences, and the words file's marks.
#include "core/base/units.hpp"
#include "core/base/words.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

namespace {

/// Inches while it lives.
struct Inches {
    Inches() { chooseUnits(UnitSystem::inches); }
    ~Inches() { chooseUnits(UnitSystem::metric); }
};

std::string shown(std::string_view numbers, std::string_view unit) {
    return std::string(inShownUnit(numbers, unit));
}

std::string filled(std::string_view sentence, PhrasePlaces places) {
    std::string text;
    detail::appendFilled(text, sentence, places);
    return text;
}

} // namespace

TEST_CASE("metric numbers and units stay as they are", "[base][units]") {
    CHECK(shown("3.50 to 4", "mm") == "3.50 to 4");
    CHECK(shownUnit("mm/s").name == "mm/s");
    CHECK_FALSE(shownUnit("mm/s").converts());
}

TEST_CASE("lengths, areas, speeds and heat inputs become inches, other units do not", "[base][units]") {
    const Inches chosen;
    CHECK(shown("25.4", "mm") == "1.000");
    CHECK(shown("3", "mm") == "0.12");
    CHECK(shown("645.16", "mm2") == "1.0000");
    CHECK(shown("8", "mm/s") == "19"); // 18.9
    CHECK(shown("8.0", "mm/s") == "18.9");
    CHECK(shown("4.5", "m/min") == "177"); // 177.2
    CHECK(shown("0.85", "kJ/mm") == "21.6");
    CHECK(shown("24.5", "V") == "24.5");
    CHECK(shownUnit("mm").name == "in");
    CHECK(shownUnit("m/min").name == "in/min");
    CHECK(shownUnit("mm2").name == "in\xC2\xB2");
    CHECK(shownUnit("V").name == "V");
}

TEST_CASE("every number of a text is converted, and nothing else", "[base][units]") {
    const Inches chosen;
    CHECK(shown("-2.5", "mm") == "-0.098");
    CHECK(shown("2 / - / 4", "mm") == "0.08 / - / 0.16");
    CHECK(shown("2,5", "mm") == "0.098");
    CHECK(shown("2.", "mm") == "0.08.");
    CHECK(shown("?", "mm") == "?");
    CHECK(shown("", "mm") == "");
}

TEST_CASE("a sentence's marks show lengths in the chosen units", "[base][units]") {
    const std::string_view sentence = "{low:mm} to {high:mm} {:mm} at {speed:mm/s} {:mm/s}";
    const PhrasePlaces places{{"low", "2"}, {"high", "12.7"}, {"speed", "6.5"}};
    CHECK(filled(sentence, places) == "2 to 12.7 mm at 6.5 mm/s");
    const Inches chosen;
    CHECK(filled(sentence, places) == "0.08 to 0.500 in at 15.4 in/min");
}

TEST_CASE("a place may name the unit of another", "[base][units]") {
    const std::string_view sentence = "{value:unit} {:unit} at {place:mm} {:mm}";
    const Inches chosen;
    CHECK(filled(sentence, {{"value", "2.54"}, {"unit", "mm"}, {"place", "10"}}) == "0.100 in at 0.39 in");
    CHECK(filled(sentence, {{"value", "24"}, {"unit", "V"}, {"place", "10"}}) == "24 V at 0.39 in");
}

TEST_CASE("fixed lengths of a lesson's text are shown in the chosen units; other braces stay", "[base][units]") {
    const std::string_view text = "Set {4.5 m/min}. Legs of {6 mm}, {later} {mm}.";
    CHECK(inChosenUnits(text) == "Set 4.5 m/min. Legs of 6 mm, {later} {mm}.");
    const Inches chosen;
    CHECK(inChosenUnits(text) == "Set 177 in/min. Legs of 0.24 in, {later} {mm}.");
    CHECK(placesOf("{3 mm} {:mm} {length:mm}") == std::vector<std::string_view>{"length"});
}

} // namespace meltpool
