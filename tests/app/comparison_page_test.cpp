// The page of two attempts: both systems of units, no loaded content, and no drawing of absent values.
#include "app/report/comparison_page.hpp"
#include "app/report/twin_curve.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <pugixml.hpp>

#include <cmath>

using namespace meltpool;

namespace {

namespace fs = std::filesystem;

fs::path folderOf(const std::string& name, const std::string& penetration, const std::string& points,
                  const std::string& speeds) {
    fs::path folder = test::scratchFolder(name);
    writeTextFileAtomically(folder / "result.json",
                            R"({"lesson": "tee <b>", "finished": true, "torch": "a.csv", "state_hash": "0f",
 "parameters": {"spacing_mm": 0.5}, "recorded": {"repetition": "simulation of the recording"},
 "arc": {"seconds": 7, "mean_current_a": 110},
 "score": {"total": )" + points +
                                R"(, "scored": true, "parameters": {"travel_speed": )" + points +
                                R"(}, "values": {"travel_speed": {"ideal": 5, "inner": 1, "outer": 3}}},
 "verdict": {"accepted": true},
 "weld": {"kind": "bead", "stations": 2, "toe_width_mm": 8, "penetration_mm": )" +
                                penetration + "}}");
    writeTextFileAtomically(folder / "technique.csv", "place_mm,judged,speed_mm_s\n0,1," + speeds + "\n");
    writeTextFileAtomically(folder / "weld.csv",
                            "place_mm,penetration_mm\n0," + penetration + "\n2," + penetration + "\n");
    writeTextFileAtomically(folder / "007.000s-metal.png", "foobar");
    return folder;
}

/// True if every tag is closed: the page without its heading, its style and the tags that HTML leaves open is XML.
bool isBalanced(const std::string& html) {
    std::string body = html.substr(html.find("<main>"), html.find("</main>") - html.find("<main>")) + "</main>";
    for (size_t at = body.find("<img "); at != std::string::npos; at = body.find("<img ", at + 1))
        body.insert(body.find('>', at), "/");
    pugi::xml_document document;
    return document.load_string(body.c_str());
}

} // namespace

TEST_CASE("the page of two attempts tells their difference in both systems and loads nothing", "[app][attempts]") {
    const ComparedRun first{"mine <script>", readRunResults(folderOf("page-one", "2", "70", "5\n1,1,5"))};
    const ComparedRun second{"yours & his", readRunResults(folderOf("page-two", "2.5", "82", "4\n1,1,4"))};
    const std::string html = comparisonPage(first, second);
    INFO(html);
    CHECK(isBalanced(html));
    for (const char* text :
         {"yours &amp; his against mine &lt;script&gt;", "tee &lt;b&gt;", "0.5 mm<", "0.020 in<", "more penetration",
          "slower travel", "score +12", "+0.5 mm<", "-1.0 mm/s<", "2.4 in/min", "simulation of the recording",
          "accepted", "class=\"first\"", "class=\"second\"", "data:image/png;base64,Zm9vYmFy", "0.25 mm<"}) {
        INFO(text);
        CHECK(html.find(text) != std::string::npos);
    }
    for (const char* text : {"http", "<script", "nan", "different lessons"}) {
        INFO(text);
        CHECK(html.find(text) == std::string::npos);
    }
    const Comparison comparison = compareRuns(first, second);
    CHECK(comparison.halfSpacing == Approx(0.25e-3));
    CHECK(comparisonText(comparison) == "0.5 mm more penetration, 1.0 mm/s slower travel, score +12");
}

TEST_CASE("a page of attempts that have little is whole", "[app][attempts]") {
    const fs::path folder = test::scratchFolder("page-bare");
    writeTextFileAtomically(folder / "result.json",
                            R"({"lesson": "classic", "finished": true, "weld": 3, "score": {"total": null}})");
    const ComparedRun bare{"bare", readRunResults(folder)};
    const std::string html = comparisonPage(bare, bare);
    CHECK(isBalanced(html));
    CHECK(html.find("No difference that the metal resolves") != std::string::npos);
    CHECK(html.find("<svg") == std::string::npos);
    CHECK(html.find("<table") == std::string::npos);
}

TEST_CASE("two curves share one sheet, and each is broken where nothing is known", "[app][attempts]") {
    const Curve first{"speed", "mm/s", {0, 1, 2}, {5, 6, 7}, std::nullopt};
    const Curve second{"speed", "mm/s", {0, 1, 2, 3, 4}, {5, 6, std::nan(""), 5, 9}, std::nullopt};
    const std::string svg = twinCurveDrawing(first, second);
    const auto count = [&](const std::string& part) {
        size_t found = 0;
        for (size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1))
            ++found;
        return found;
    };
    CHECK(count("class=\"first\"") == 1);
    CHECK(count("class=\"second\"") == 2);
    CHECK(svg.find("48.0,106.0") != std::string::npos); // 0 mm, the smaller of both values
    CHECK(svg.find("632.0,22.0") != std::string::npos); // 4 mm, the larger one
    CHECK_THAT(svg, test::containsText("speed (mm/s) along the seam (mm)"));
    CHECK_THAT(svg, test::containsText("speed (in/min) along the seam (in)"));
    CHECK_THAT(svg, test::containsText("class=\"in\" x=\"43.0\"")); // number at the left in the other system
    CHECK(twinCurveDrawing({"a", "mm", {0}, {std::nan("")}, std::nullopt}, {"a", "mm", {}, {}, std::nullopt}).empty());
}
