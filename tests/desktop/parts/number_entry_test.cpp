// Tests typing a number in place of a slider: either decimal mark, refused text, Escape, the press that opens it.
#include "app/ui/number_entry.hpp"
#include "core/base/units.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"

#include <limits>

namespace meltpool {

namespace {

/// A slider for a voltage, and the frames that draw it.
struct Voltage {
    float volts = 24;
    test::DrawnInterface interface;

    ParameterList list() { return {{"voltage", "Voltage", "V", &volts, 10, 40, ""}}; }
    DefaultTexts defaults{{"voltage", "24"}};

    auto content() {
        return [this](ui::Context& context) { ui::parameterControl(context, "machine", list().front(), defaults); };
    }
    void draw() {
        const auto drawn = content();
        interface.draw(drawn);
    }
    void openByValue() {
        const auto drawn = content();
        draw();
        interface.click("machine.voltage.value", drawn);
        draw();
    }
    void enter(std::string_view text) {
        const auto drawn = content();
        interface.type(text, drawn);
        interface.strike(ImGuiKey_Enter, drawn);
        draw();
    }
};

} // namespace

TEST_CASE("a typed number has a point or a comma, and its unit if the person likes") {
    CHECK(ui::typedNumber("24.3") == 24.3);
    CHECK(ui::typedNumber("24,3") == 24.3);
    CHECK(ui::typedNumber(" 24,3 V ", "V") == 24.3);
    CHECK(ui::typedNumber("-1e-3") == -1e-3);
    for (const char* text : {"", "V", "24,3,1", "1,234.5", "24 A", "twenty", "nan", "inf", "0x10"}) {
        INFO(text);
        CHECK(!ui::typedNumber(text, "V").has_value());
    }
}

TEST_CASE("a range takes its ends, and whole numbers only if it counts") {
    const ui::NumberRange volts{10, 40, false, "V"}, layers{1, 8, true, {}};
    CHECK((volts.takes(10) && volts.takes(40) && volts.takes(24.3)));
    CHECK(!(volts.takes(9.99) || volts.takes(std::numeric_limits<double>::quiet_NaN())));
    CHECK((layers.takes(3) && !layers.takes(2.5)));
}

TEST_CASE("a click on a slider's value opens the text field, and Enter takes the number") {
    Voltage control;
    control.openByValue();
    CHECK(control.volts == 24);
    CHECK(!control.interface.shows("machine.voltage"));
    control.enter("31,5");
    CHECK(control.volts == 31.5f);
    CHECK(control.interface.shows("machine.voltage"));
}

TEST_CASE("a double click on a slider opens the text field and leaves the value as it was") {
    Voltage control;
    control.volts = 38;
    const auto drawn = control.content();
    control.draw();
    control.interface.doubleClick("machine.voltage", drawn);
    control.draw();
    CHECK(control.volts == 38);
    CHECK(!control.interface.shows("machine.voltage"));
    control.enter("12");
    CHECK(control.volts == 12);
}

TEST_CASE("Escape closes the text field and changes nothing") {
    Voltage control;
    control.volts = 38.125f;
    const auto drawn = control.content();
    control.openByValue();
    control.interface.type("12", drawn);
    control.interface.strike(ImGuiKey_Escape, drawn);
    control.draw();
    CHECK(control.volts == 38.125f);
    CHECK(control.interface.shows("machine.voltage"));
    CHECK(!control.interface.shows("machine.voltage.refused"));
}

TEST_CASE("a refused number changes nothing, shows its reason, and stays to be corrected") {
    const std::string text = GENERATE("99", "abc", "24,3,1");
    Voltage control;
    control.openByValue();
    control.enter(text);
    CHECK(control.volts == 24);
    CHECK(control.interface.shows("machine.voltage.refused"));
    CHECK(!control.interface.shows("machine.voltage"));
    control.draw();
    control.enter("30");
    CHECK(control.volts == 30);
    CHECK(!control.interface.shows("machine.voltage.refused"));
}

TEST_CASE("with inches a speed is shown, typed and refused in inches per minute, and kept metric") {
    chooseUnits(UnitSystem::inches);
    float feed = 4.5f;
    test::DrawnInterface interface;
    const Parameter parameter{"wire_feed_m_min", "Wire feed", "m/min", &feed, 1, 20, ""};
    const DefaultTexts defaults{{"wire_feed_m_min", "4.5"}};
    const auto drawn = [&](ui::Context& context) { ui::parameterControl(context, "machine", parameter, defaults); };
    const auto enter = [&](std::string_view text) {
        interface.draw(drawn);
        interface.click("machine.wire_feed_m_min.value", drawn);
        interface.draw(drawn);
        interface.type(text, drawn);
        interface.strike(ImGuiKey_Enter, drawn);
        interface.draw(drawn);
    };
    enter("200 in/min");
    CHECK(feed == Approx(5.08));
    enter("20");
    CHECK(interface.shows("machine.wire_feed_m_min.refused"));
    CHECK(feed == Approx(5.08));
    chooseUnits(UnitSystem::metric);
}

TEST_CASE("without a keyboard a double click opens no text field") {
    Voltage control;
    control.interface.context().typing = false;
    control.draw();
    CHECK(!control.interface.shows("machine.voltage.value"));
    const auto drawn = control.content();
    control.interface.doubleClick("machine.voltage", drawn);
    control.draw();
    CHECK(control.interface.shows("machine.voltage"));
}

} // namespace meltpool
