// Tests likely causes and remedies in the result panel, drawn by the installed Dear ImGui without a window.
#include "app/ui/panels.hpp"
#include "tests/desktop/parts/drawn_interface.hpp"
#include "tests/support/catch.hpp"

#include <vector>

namespace meltpool {

namespace {

class CureInterface : public test::DrawnInterface {
  public:
    /// Draws one frame with the cures; returns the pressed one.
    std::optional<size_t> frame(const std::vector<CureRow>& cures, bool tries) {
        std::optional<size_t> chosen;
        draw([&](ui::Context& context) { chosen = ui::curesPart(context, cures, tries); });
        return chosen;
    }
};

std::vector<CureRow> twoCures() {
    return {{"Undercut at 3 mm: likely the arc dug in and no metal filled the groove. Aim lower.", {}, {}},
            {"Overlap at 12 mm: likely too little heat for the plate there. Set the voltage to 20 V as in the lesson.",
             "voltage=20", "voltage 20 V instead of 17"}};
}

} // namespace

TEST_CASE("each cure is shown, and one that can be tried has a button") {
    CureInterface interface;
    interface.frame({}, true);
    CHECK_FALSE(interface.shows("result.cure.1"));
    const std::vector<CureRow> cures = twoCures();
    interface.frame(cures, true);
    interface.frame(cures, true);
    CHECK(interface.shows("result.cure.1"));
    CHECK(interface.shows("result.cure.2"));
    CHECK_FALSE(interface.shows("result.cure.1.try"));
    CHECK(interface.shows("result.cure.2.try"));
    CHECK(interface.place("result.cure.2").y > interface.place("result.cure.1").y);

    std::optional<size_t> chosen;
    interface.click("result.cure.2.try", [&](ui::Context& context) {
        if (const auto pressed = ui::curesPart(context, cures, true)) chosen = pressed;
    });
    CHECK(chosen == 1);
}

TEST_CASE("an attempt without a recording shows the cures without a button") {
    CureInterface interface;
    const std::vector<CureRow> cures = twoCures();
    interface.frame(cures, false);
    CHECK_FALSE(interface.frame(cures, false));
    CHECK(interface.shows("result.cure.2"));
    CHECK_FALSE(interface.shows("result.cure.2.try"));
}

} // namespace meltpool
