// Lessons as files: shipped ones are sound, every value can be set, and bad files are refused by line.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/training/lesson/lesson.hpp"
#include "core/weld/workpiece/position.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <random>
#include <set>

using namespace meltpool;
using meltpool::test::containsText;

namespace {

std::filesystem::path shippedLessons() {
    return test::testFolder().parent_path() / "app" / "data" / "lessons";
}

Lesson lessonFrom(const std::string& text) {
    const auto file = test::scratchFolder("lesson") / "bad.toml";
    writeTextFileAtomically(file, text);
    return readLesson(file);
}

std::string refusal(const std::string& text) {
    try {
        lessonFrom(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("every lesson of the catalogue can be read and has a title and a demonstration", "[training]") {
    const auto names = lessonNames(shippedLessons());
    REQUIRE(std::find(names.begin(), names.end(), kDefaultLesson) != names.end());
    for (const std::string& name : names) {
        INFO(name);
        const Lesson lesson = findLesson(name, shippedLessons());
        CHECK(lesson.key == name);
        CHECK(lesson.title != name);
        CHECK_FALSE(lesson.text.empty());
        CHECK(lesson.torch.duration() > 0);
        CHECK(lesson.torch.duration() <= static_cast<double>(lesson.run.seconds));
        CHECK_FALSE(lesson.pictures.empty());
        CHECK(lesson.level >= 1);
        CHECK(lesson.listPicture == shippedLessons() / "pictures" / (name + ".png"));
        if (!lesson.next.empty()) CHECK(std::find(names.begin(), names.end(), lesson.next) != names.end());
    }
}

TEST_CASE("no two values of a lesson share a key, and every default lies in its range", "[training]") {
    Lesson lesson;
    std::set<std::string_view> keys;
    for (const Parameter& parameter : lesson.parameters()) {
        INFO(parameter.key);
        CHECK(keys.insert(parameter.key).second);
        CHECK_FALSE(parameter.note.empty());
        const std::string before = parameterText(parameter);
        CHECK_NOTHROW(lesson.set(parameter.key, before, "test"));
        CHECK(parameterText(parameter) == before);
    }
}

TEST_CASE("a value set on a lesson reaches the looks of its pictures", "[training]") {
    Lesson lesson = findLesson("classic", shippedLessons());
    REQUIRE(lesson.pictures.size() == 2);
    CHECK(lesson.pictures[0].look.colours == kMaterialColours);
    CHECK(lesson.pictures[1].look.colours == kTemperatureColours);
    lesson.set("material", "copper", "--set");
    CHECK(lesson.look.material == kCopper);
    CHECK(lesson.pictures[0].look.material == kCopper);
    CHECK(lesson.pictures[1].look.material == kCopper);
    CHECK(lesson.pictures[1].look.colours == kTemperatureColours);
    CHECK_THROWS_WITH(lesson.set("material", "cheese", "--set material=cheese"),
                      containsText("expected one of solder"));
    CHECK(lesson.pictures[0].look.material == kCopper);
}

TEST_CASE("a picture has its own camera and cut, which begin with the lesson's", "[training]") {
    Lesson lesson = lessonFrom("title = 'T'\nmodel = 'weld'\n[camera]\nazimuth = 10\ndistance = 2\n"
                               "[[picture]]\nname = 'whole'\n"
                               "[[picture]]\nname = 'cut'\nsection_at_mm = -5\nmeasures = true\nazimuth = 70\n");
    CHECK(lesson.pictures[0].camera.azimuth == 10);
    CHECK_FALSE(lesson.pictures[0].sectionAt.has_value());
    CHECK(lesson.pictures[1].camera.azimuth == 70);
    CHECK(lesson.pictures[1].camera.distance == 2);
    CHECK(lesson.pictures[1].sectionAt.value() == Approx(-0.005f));
    CHECK(lesson.pictures[1].measures);
    CHECK_FALSE(lesson.pictures[0].measures);
    lesson.set("distance", "4", "--set");
    CHECK(lesson.pictures[1].camera.distance == 4);
}

TEST_CASE("groups of a lesson's file fill what they name", "[training]") {
    const Lesson lesson = lessonFrom("title = 'T'\ntext = 'do it'\n"
                                     "[run]\nseconds = 3\nwidth = 320\nheight = 200\n"
                                     "[start]\nparticles = 77\narrangement = 'random'\n"
                                     "[metal]\ngravity = [0, -1, 0.5]\nsolidify_rate = 0.25\n"
                                     "[source]\nsource = 'cold'\n"
                                     "[surface]\ncells = 32\ncaps = false\n"
                                     "[camera]\nazimuth = -20\n"
                                     "[look]\nmaterial = 'ice'\n"
                                     "[[picture]]\nname = 'points'\nmode = 'points'\n");
    CHECK(lesson.title == "T");
    CHECK(lesson.run.width == 320);
    CHECK(lesson.setup.particles == 77);
    CHECK(lesson.setup.arrangement == ClassicSetup::kRandom);
    CHECK(lesson.metal.gravity == glm::vec3(0, -1, 0.5f));
    CHECK(lesson.metal.solidifyRate == 0.25f);
    CHECK(lesson.source.kind == 1);
    CHECK(lesson.surface.cells == 32);
    CHECK_FALSE(lesson.surface.caps);
    CHECK(lesson.camera.azimuth == -20);
    REQUIRE(lesson.pictures.size() == 1);
    CHECK(lesson.pictures[0].look.material == kIce);
    CHECK(lesson.pictures[0].look.mode == kPointsMode);
    CHECK(lesson.torch.empty());
}

TEST_CASE("a weld lesson names the bands of its technique and the limits of its weld", "[training]") {
    const Lesson lesson =
        lessonFrom("model = 'weld'\n[workpiece]\nworkpiece = 'tee'\nlength_mm = 40\nthickness_mm = 5\n"
                   "[process]\nprocess = 'gtaw'\n"
                   "[technique]\nlength_from_mm = -12\nlength_to_mm = 10\n"
                   "arc_length = { ideal = 2, inner = 0.5, outer = 2 }\n"
                   "travel_speed = { ideal = 3, inner = 0.5, outer = 2, weight = 2 }\n"
                   "[acceptance]\nuse = 'iso5817-b'\nleg_mm = 4\n");
    REQUIRE(lesson.technique);
    CHECK(lesson.technique->distance == DistanceKind::arcLength);
    CHECK(lesson.technique->lengthFromMm == -12);
    REQUIRE(lesson.technique->find(TechniqueQuantity::distance) != nullptr);
    CHECK(lesson.technique->find(TechniqueQuantity::travelSpeed)->weight == 2);
    REQUIRE(lesson.acceptance);
    CHECK(lesson.acceptance->level == "B");
    CHECK(lesson.nominalWeld().thickness == Approx(5e-3));
    CHECK(lesson.nominalWeld().leg == Approx(4e-3));
    CHECK(lesson.nominal.leg == Approx(4e-3));
    CHECK_FALSE(lesson.nominal.throat);
}

TEST_CASE("limits take the thickness that is simulated, whatever spacing is set later", "[training]") {
    Lesson lesson = lessonFrom("model = 'weld'\n[workpiece]\nworkpiece = 'tee'\nthickness_mm = 4.5\nspacing_mm = 0.9\n"
                               "[process]\nprocess = 'gtaw'\n[acceptance]\nuse = 'iso5817-b'\nleg_mm = 4\n");
    CHECK(lesson.nominalWeld().thickness == Approx(4.5e-3));
    lesson.set("spacing_mm", "1", "here");
    CHECK(lesson.nominalWeld().thickness == Approx(5e-3));
}

TEST_CASE("the legs of an outside corner's groove are not asked for", "[training]") {
    CHECK(findLesson("corner-1f", shippedLessons()).nominalWeld().betweenEdges);
    CHECK_FALSE(findLesson("tee-thin", shippedLessons()).nominalWeld().betweenEdges);
}

TEST_CASE("shipped lessons on plates of 3 mm are judged by the rows of thin plates", "[training]") {
    std::set<std::string> thin;
    for (const std::string& name : lessonNames(shippedLessons())) {
        const Lesson lesson = findLesson(name, shippedLessons());
        if (!lesson.acceptance || lesson.nominalWeld().thickness > 3.05e-3 || name == "solder-joint") continue;
        INFO(name);
        thin.insert(name);
        LimitSizes sizes;
        sizes.t = lesson.nominalWeld().thickness * 1e3;
        int rows = 0;
        for (const AcceptanceItem& item : lesson.acceptance->items) {
            if (!item.t.bounded() || !item.holdsFor(sizes)) continue;
            CHECK(item.t.high == 3);
            ++rows;
        }
        CHECK(rows > 4);
    }
    CHECK(thin == std::set<std::string>{"butt-1g", "corner-1f", "gtaw-butt", "lap-2f", "tee-thin"});
}

TEST_CASE("a fillet is judged by the size that the lesson's text asks for", "[training]") {
    int fillets = 0;
    for (const std::string& name : lessonNames(shippedLessons())) {
        const Lesson lesson = findLesson(name, shippedLessons());
        if (!lesson.acceptance || weldKindOf(lesson.workpiece) != WeldKind::fillet) continue;
        INFO(name << ": " << lesson.text);
        ++fillets;
        REQUIRE(lesson.nominal.leg.has_value() != lesson.nominal.throat.has_value());
        const bool leg = lesson.nominal.leg.has_value();
        const double size = (leg ? *lesson.nominal.leg : *lesson.nominal.throat) * 1e3;
        const std::string asked = " of " + formatNumber(size) + " mm",
                          about = " of about " + formatNumber(size) + " mm";
        const auto names = [&](const std::string& word) {
            return lesson.text.find(word + asked) != std::string::npos ||
                   lesson.text.find(word + about) != std::string::npos;
        };
        CHECK((leg ? names("leg") || names("legs") : names("throat")));
    }
    CHECK(fillets == 7);
}

TEST_CASE("a lesson lets the trainee choose settings within its limits", "[training]") {
    const std::string process = "model = 'weld'\n[process]\nprocess = 'gmaw'\nvoltage = 19\nwire_feed_m_min = 4\n";
    Lesson lesson = lessonFrom(process + "[choose]\nvoltage = { from = 17.4, to = 21, start = 15 }\n"
                                         "wire_feed_m_min = { from = 3.5, to = 5 }\n");
    REQUIRE(lesson.choose.size() == 2);
    CHECK(lesson.choose[0].start == 15);
    CHECK_FALSE(lesson.choose[1].start);
    CHECK(lesson.process.of<Gmaw>().voltage == 19); // the lesson's own value
    CHECK(lesson.unsetSettings().empty());
    CHECK_THROWS_WITH(lesson.set("voltage", "21.1", "--set voltage=21.1"),
                      containsText("--set voltage=21.1: 'voltage' is '21.1'; expected a number from 17.4 to 21 (V)"));
    CHECK_THROWS_AS(lesson.set("wire_feed_m_min", "3.4", "test"), InputError);
    CHECK_NOTHROW(lesson.set("voltage", "17.4", "test"));
    CHECK_NOTHROW(lesson.set("wire_diameter_mm", "0.8", "test")); // a given value outside a test
    CHECK(lesson.chosenText() == "voltage 17.4 V, wire feed 4 m/min");
    lesson.takeStartSettings();
    CHECK(lesson.process.of<Gmaw>().voltage == 15);
    CHECK(lesson.process.of<Gmaw>().wireFeedMPerMin == 4);
    CHECK(lesson.unsetSettings() == "Set the machine before you weld: voltage 17.4 to 21 V (now 15).");
    CHECK(lessonFrom(process).chosenText().empty());
    CHECK(findLesson("gmaw-bead", shippedLessons()).choose.size() == 2);
}

TEST_CASE("a weld lesson names joint, position and tacks", "[training]") {
    const Lesson lesson = lessonFrom("model = 'weld'\n[workpiece]\nworkpiece = 'corner'\nposition = '3F'\n"
                                     "tack_count = 3\ntack_length_mm = 10\n");
    CHECK(lesson.workpiece.kind == static_cast<int>(WorkpieceKind::Corner));
    CHECK(fixtureOf(lesson.workpiece).down() == glm::vec3(-1, 0, 0)); // upward seam
    CHECK(lesson.workpiece.tackCount == 3);
    CHECK(lesson.workpiece.tackLengthMm == 10);
}

TEST_CASE("a lesson says how hard it is, which one follows and which picture stands for it", "[training]") {
    const Lesson lesson = lessonFrom("level = 4\nnext = 'tee-fillet'\nlist_picture = '../tile.png'\n");
    CHECK(lesson.level == 4);
    CHECK(lesson.next == "tee-fillet");
    CHECK(lesson.listPicture == (lesson.file.parent_path() / ".." / "tile.png").lexically_normal());
    const Lesson plain = lessonFrom("");
    CHECK(plain.level == 0);
    CHECK(plain.next.empty());
    CHECK(plain.listPicture == plain.file.parent_path() / "pictures" / "bad.png");
}

TEST_CASE("a bad lesson is refused in one sentence with file, line and expectation", "[training]") {
    struct Case {
        std::string text, place, expectation;
    };
    const std::vector<Case> cases{
        {"titel = 'x'\n", "bad.toml:1: ", "unknown key"},
        {"title = \n", "bad.toml:1: ", ""},
        {"title = 'x'\n[metal]\nviscosity = -1\n", "bad.toml:3: ", "expected a number from"},
        {"title = 'x'\n[metal]\nviscosity = 'much'\n", "bad.toml:3: ", "expected a number from"},
        {"title = 'x'\n[metal]\nviscosity = nan\n", "bad.toml:3: ", "expected"},
        {"title = 'x'\n[start]\n\nparticles = 0\n", "bad.toml:4: ", "expected a whole number from 1"},
        {"title = 'x'\n[start]\nparticles = 10.5\n", "bad.toml:3: ", "expected a whole number"},
        {"title = 'x'\n[look]\nmaterial = 'cheese'\n", "bad.toml:3: ", "expected one of solder"},
        {"title = 'x'\n[look]\nglitter = 1\n", "bad.toml:3: ", "unknown key"},
        {"title = 'x'\nlook = 3\n", "bad.toml:2: ", "expected a table"},
        {"title = 'x'\nlevel = 6\n", "bad.toml:2: ", "expected a number from 1 to 5"},
        {"title = 'x'\nlevel = 1.5\n", "bad.toml:2: ", "expected a whole number from 1 to 5"},
        {"title = 'x'\nnext = '../evil'\n", "bad.toml:2: ", "expected the name of a lesson"},
        {"title = 'x'\nlist_picture = 3\n", "bad.toml:2: ", "expected a text"},
        {"title = 'x'\nmodel = 'clay'\n", "bad.toml:2: ", "expected classic"},
        {"title = 'x'\ntorch = 'nowhere.csv'\n", "nowhere.csv: ", "expected a readable file"},
        {"title = 'x'\n[[picture]]\nname = 'a'\nsection_at_mm = 1\n", "bad.toml:4: ", "expected a lesson whose model"},
        {"model = 'weld'\n[[picture]]\nname = 'a'\nmeasures = true\n", "bad.toml:4: ", "expected section_at_mm too"},
        {"model = 'weld'\n[technique]\nlength_from_mm = 0\nlength_to_mm = 9\nskill = { ideal = 1 }\n",
         "bad.toml:5: ", "unknown key"},
        {"model = 'weld'\n[acceptance]\nuse = 'iso5817-z'\n", "bad.toml:3: ", "expected one of"},
        {"model = 'weld'\n[acceptance]\nuse = 'iso5817-c'\nleg_mm = 0\n", "bad.toml:4: ", "expected a number"},
        {"model = 'weld'\n[workpiece]\nworkpiece = 'butt'\nposition = '2F'\n",
         "bad.toml:4: ", "expected one of as_it_lies, flat, 1G, 2G, 3G, 4G"},
        {"model = 'weld'\n[workpiece]\nposition = 'upside_down'\n", "bad.toml:3: ", "expected one of as_it_lies"},
        {"model = 'weld'\n[workpiece]\nworkpiece = 'butt'\nroot_face_mm = 9\n",
         "bad.toml:4: ", "expected at most thickness_mm"},
        {"model = 'weld'\n[workpiece]\nworkpiece = 'pipe'\ndiameter_mm = 20\nthickness_mm = 10\n",
         "bad.toml:5: ", "expected less than half of diameter_mm"},
        {"model = 'weld'\n[workpiece]\ntack_count = 2\n", "bad.toml:3: ", "expected 0"},
        {"model = 'weld'\n[choose]\nvoltage = { from = 1, to = 2 }\n", "bad.toml:3: ", "unknown key"}, // key of GTAW
        {"model = 'weld'\n[choose]\nprocess = { from = 1, to = 2 }\n", "bad.toml:3: ", "unknown key"},
        {"model = 'weld'\n[choose]\ncurrent = 100\n", "bad.toml:3: ", "expected a table"},
        {"model = 'weld'\n[choose]\ncurrent = { from = 100 }\n", "bad.toml:3: ", "to"},
        {"model = 'weld'\n[choose]\ncurrent = { from = 100, to = 90 }\n", "bad.toml:3: ", "expected a number from 100"},
        {"model = 'weld'\n[choose]\ncurrent = { from = 100, to = 501 }\n", "bad.toml:3: ", "to 500"},
        {"model = 'weld'\n[choose]\ncurrent = { from = 100, to = 150, by = 5 }\n", "bad.toml:3: ", "unknown key"},
        {"model = 'weld'\n[process]\ncurrent = 90\n[choose]\ncurrent = { from = 100, to = 150 }\n",
         "bad.toml:5: ", "expected limits around the lesson's own value, 90"},
        {"model = 'weld'\n[process]\nprocess = 'smaw'\n[choose]\nelectrode = { from = 0, to = 1 }\n",
         "bad.toml:5: ", "expected a numeric setting"},
        {"model = 'weld'\n[process]\nprocess = 'gmaw'\ngas = 'helium'\n",
         "bad.toml:4: ", "expected one of ar_co2, co2, ar_o2, ar, none"},
        {"model = 'weld'\n[process]\nprocess = 'gmaw'\ngas_flow_l_min = -1\n",
         "bad.toml:4: ", "expected a number from 0"},
        {"model = 'weld'\n[process]\nprocess = 'gtaw'\ngas = 'co2'\n", "bad.toml:4: ", "expected one of ar"},
        {"model = 'weld'\n[process]\nprocess = 'smaw'\ngas = 'ar'\n", "bad.toml:4: ", "unknown key"},
        {"[choose]\ncurrent = { from = 1, to = 2 }\n", "bad.toml:1: ", "unknown key"}, // classic lesson
        {"[technique]\nlength_from_mm = 0\n", "bad.toml:1: ", "unknown key"},          // the classic model has no seam
        {"title = 'x'\n[[picture]]\nname = '../evil'\n", "bad.toml:3: ", "expected letters"},
        {"title = 'x'\n[[picture]]\nname = 'a'\n[[picture]]\nname = 'a'\n", "bad.toml:5: ", "appears twice"},
    };
    for (const Case& bad : cases) {
        INFO(bad.text);
        const std::string sentence = refusal(bad.text);
        CHECK_THAT(sentence, containsText(bad.place));
        CHECK_THAT(sentence, containsText(bad.expectation));
        CHECK(sentence.find('\n') == std::string::npos);
    }
}

TEST_CASE("an unknown lesson is refused with the names that there are", "[training]") {
    CHECK_THROWS_WITH(findLesson("clasic", shippedLessons()),
                      containsText("did you mean 'classic'? Expected one of butt-1g, classic"));
    CHECK_THROWS_WITH(findLesson("nowhere/mine.toml", shippedLessons()), containsText("nowhere/mine.toml"));
}

TEST_CASE("damaged lessons are refused with their file or give values in range", "[training]") {
    std::string whole = readTextFile(shippedLessons() / "classic.toml");
    const size_t torch = whole.find("torch = ");
    whole.erase(torch, whole.find('\n', torch) - torch); // the path is not next to the damaged copy
    std::mt19937 random(5);
    const std::string letters = "0123456789.-e#\n \"[]=ax\xff";
    int taken = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string text = whole;
        for (size_t wounds = 1 + random() % 3; wounds > 0; --wounds)
            text[random() % text.size()] = letters[random() % letters.size()];
        INFO(text);
        try {
            Lesson lesson = lessonFrom(text);
            for (const Parameter& parameter : lesson.parameters())
                REQUIRE_NOTHROW(lesson.set(parameter.key, parameterText(parameter), "again"));
            ++taken;
        } catch (const InputError& error) {
            REQUIRE_THAT(error.what(), containsText("bad.toml"));
        }
    }
    CHECK(taken > 10);
    CHECK(taken < 990);
}

TEST_CASE("a lesson knows which settings are its own, and how far they may be from those", "[training]") {
    Lesson lesson = findLesson("gmaw-bead", shippedLessons());
    const auto fact = [&](std::string_view key) {
        const std::vector<SettingFact> facts = lesson.settingFacts();
        const auto found = std::find_if(facts.begin(), facts.end(), [&](const SettingFact& f) { return f.key == key; });
        REQUIRE(found != facts.end());
        return *found;
    };
    lesson.set("voltage", "20.5", "test");
    lesson.set("stick_out_mm", "20", "test");
    lesson.set("thickness_mm", "4", "test");
    const SettingFact volts = fact("voltage");
    CHECK(volts.name == "voltage");
    CHECK(volts.unit == "V");
    CHECK((volts.value == 20.5 && volts.asked == 19 && volts.ofMachine));
    CHECK((volts.least == 16 && volts.most == 26)); // the trainee's choice
    CHECK((volts.lowest == 16 && volts.highest == 26));
    const SettingFact given = fact("stick_out_mm");
    CHECK((given.value == 20 && given.asked == 12));
    CHECK(given.most == Approx(12.24));
    const SettingFact plate = fact("thickness_mm");
    CHECK((plate.value == 4 && plate.asked == 6 && !plate.ofMachine));
    lesson.set("process", "gtaw", "test"); // its settings mean something else
    CHECK(fact("current").value == fact("current").asked);
    lesson.own.reset();
    CHECK(fact("thickness_mm").asked == 4);
    CHECK(findLesson("classic", shippedLessons()).settingFacts().empty());
}
