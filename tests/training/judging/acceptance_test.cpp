// The shipped acceptance files: they hold the standards' numbers, and faults are reported with file, line and key;
// limits in mm and degrees.
#include "core/training/judging/acceptance.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <limits>
#include <set>

using namespace meltpool;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Acceptance shipped(const std::string& name) {
    return readAcceptance(test::testFolder().parent_path() / "app" / "data" / "acceptance" / (name + ".toml"));
}

/// Returns the item for an imperfection of a weld of these sizes; the test fails unless there is exactly one.
AcceptanceItem itemOf(const Acceptance& acceptance, const std::string& imperfection, WeldKind kind,
                      const LimitSizes& sizes = {8, 4, 6, 5.6}) {
    std::vector<AcceptanceItem> found;
    for (const AcceptanceItem& item : acceptance.items)
        if (item.imperfection == imperfection && item.appliesToKind(kind) && item.holdsFor(sizes))
            found.push_back(item);
    INFO(imperfection);
    REQUIRE(found.size() == 1);
    return found.front();
}

double limitOf(const Acceptance& acceptance, const std::string& imperfection, WeldKind kind,
               const LimitSizes& sizes = {8, 4, 6, 5.6}) {
    return itemOf(acceptance, imperfection, kind, sizes).formula.at(sizes);
}

double shortLimit(const Acceptance& acceptance, const std::string& imperfection, WeldKind kind,
                  const LimitSizes& sizes = {8, 4, 6, 5.6}) {
    const AcceptanceItem item = itemOf(acceptance, imperfection, kind, sizes);
    REQUIRE(item.shortOnes);
    CHECK(item.kind == LimitKind::notPermitted);
    return item.shortOnes->formula.at(sizes);
}

} // namespace

namespace {

/// A cell of the standard's table at some sizes: a limit in mm or degrees.
struct Cell {
    enum class Kind { allowed, no, atMost, shortAtMost, atLeast } kind = Kind::no;
    double limit = 0;
};

constexpr Cell allowed{Cell::Kind::allowed};
constexpr Cell no{};

constexpr Cell upTo(double limit) {
    return {Cell::Kind::atMost, limit};
}

/// Not permitted, and this much over short lengths.
constexpr Cell brief(double limit) {
    return {Cell::Kind::shortAtMost, limit};
}

constexpr Cell from(double limit) {
    return {Cell::Kind::atLeast, limit};
}

struct IsoRow {
    const char* imperfection;
    WeldKind kind;
    std::array<Cell, 3> thin;  ///< levels D, C, B of plates of 2 mm, throat 2, width 5
    std::array<Cell, 3> thick; ///< of plates of 6 mm, throat 4, width 8
    std::array<Cell, 3> huge;  ///< of plates of 60 mm, throat 40, width 100: the caps
};

constexpr LimitSizes kThin{5, 2, 2, 2.8}, kThick{8, 4, 6, 5.6}, kHuge{100, 40, 60, 56};

constexpr std::array<Cell, 3> every(Cell cell) {
    return {cell, cell, cell};
}

const std::array<IsoRow, 25> kIsoRows{
    {{"crack", WeldKind::bead, every(no), every(no), every(no)},
     {"surface_pore", WeldKind::fillet, {upTo(0.6), no, no}, {upTo(1.2), upTo(0.8), no}, {upTo(3), upTo(2), no}},
     {"end_crater_pipe", WeldKind::butt, {upTo(0.4), no, no}, {upTo(1.2), upTo(0.6), no}, {upTo(2), upTo(1), no}},
     {"lack_of_fusion", WeldKind::fillet, every(no), every(no), every(no)},
     {"root_penetration_missing", WeldKind::butt, {brief(0.4), no, no}, {brief(1.2), no, no}, {brief(2), no, no}},
     {"undercut",
      WeldKind::fillet,
      {brief(0.4), brief(0.2), no},
      {upTo(1), upTo(0.5), upTo(0.3)},
      {upTo(1), upTo(0.5), upTo(0.5)}},
     {"root_groove",
      WeldKind::butt,
      {upTo(0.4), brief(0.2), no},
      {brief(1.2), brief(0.6), brief(0.3)},
      {brief(2), brief(1), brief(0.5)}},
     {"excess_weld_metal",
      WeldKind::butt,
      {upTo(2.25), upTo(1.75), upTo(1.5)},
      {upTo(3), upTo(2.2), upTo(1.8)},
      {upTo(10), upTo(7), upTo(5)}},
     {"convexity",
      WeldKind::fillet,
      {upTo(2.25), upTo(1.75), upTo(1.5)},
      {upTo(3), upTo(2.2), upTo(1.8)},
      {upTo(5), upTo(4), upTo(3)}},
     {"excess_penetration",
      WeldKind::butt,
      {upTo(4), upTo(2.5), upTo(1.5)},
      {upTo(5), upTo(4), upTo(2.6)},
      {upTo(5), upTo(4), upTo(3)}},
     {"toe_angle",
      WeldKind::butt,
      {from(90), from(110), from(150)},
      {from(90), from(110), from(150)},
      {from(90), from(110), from(150)}},
     {"toe_angle",
      WeldKind::fillet,
      {from(90), from(100), from(110)},
      {from(90), from(100), from(110)},
      {from(90), from(100), from(110)}},
     {"overlap", WeldKind::fillet, {upTo(1), no, no}, {upTo(1.6), no, no}, {upTo(20), no, no}},
     {"incompletely_filled_groove",
      WeldKind::butt,
      {brief(0.5), brief(0.2), no},
      {brief(1.5), brief(0.6), brief(0.3)},
      {brief(2), brief(1), brief(0.5)}},
     {"burn_through", WeldKind::butt, every(no), every(no), every(no)},
     {"excessive_asymmetry",
      WeldKind::fillet,
      {upTo(2.4), upTo(2.3), upTo(1.8)},
      {upTo(2.8), upTo(2.6), upTo(2.1)},
      {upTo(10), upTo(8), upTo(7.5)}},
     {"root_concavity",
      WeldKind::butt,
      {upTo(0.4), brief(0.2), no},
      {brief(1.2), brief(0.6), brief(0.3)},
      {brief(2), brief(1), brief(0.5)}},
     {"poor_restart", WeldKind::fillet, {allowed, no, no}, {allowed, no, no}, {allowed, no, no}},
     {"insufficient_throat",
      WeldKind::fillet,
      {brief(0.4), brief(0.2), no},
      {brief(0.7), brief(0.7), no},
      {brief(2), brief(1), no}},
     {"excessive_throat",
      WeldKind::fillet,
      {allowed, upTo(1.4), upTo(1.3)},
      {allowed, upTo(1.8), upTo(1.6)},
      {allowed, upTo(4), upTo(3)}},
     {"stray_arc", WeldKind::bead, {allowed, no, no}, {allowed, no, no}, {allowed, no, no}},
     {"linear_misalignment",
      WeldKind::butt,
      {upTo(0.7), upTo(0.5), upTo(0.4)},
      {upTo(1.5), upTo(0.9), upTo(0.6)},
      {upTo(5), upTo(4), upTo(3)}},
     {"joint_gap",
      WeldKind::fillet,
      {upTo(0.7), upTo(0.5), upTo(0.4)},
      {upTo(2.2), upTo(1.3), upTo(0.9)},
      {upTo(4), upTo(3), upTo(2)}},
     {"undercut",
      WeldKind::butt,
      {brief(0.4), brief(0.2), no},
      {upTo(1), upTo(0.5), upTo(0.3)},
      {upTo(1), upTo(0.5), upTo(0.5)}},
     {"lack_of_fusion", WeldKind::butt, every(no), every(no), every(no)}}};

void checkCell(const Acceptance& acceptance, const IsoRow& row, const Cell& cell, const LimitSizes& sizes) {
    INFO(row.imperfection << ", " << nameOf(row.kind) << ", level " << acceptance.level << ", t " << sizes.t);
    if (cell.kind == Cell::Kind::allowed) {
        for (const AcceptanceItem& item : acceptance.items)
            CHECK(item.imperfection != row.imperfection);
        return;
    }
    const AcceptanceItem item = itemOf(acceptance, row.imperfection, row.kind, sizes);
    CHECK(item.shortOnes.has_value() == (cell.kind == Cell::Kind::shortAtMost));
    if (cell.kind == Cell::Kind::atMost || cell.kind == Cell::Kind::atLeast) {
        CHECK(item.kind == (cell.kind == Cell::Kind::atMost ? LimitKind::atMost : LimitKind::atLeast));
        CHECK(item.formula.at(sizes) == Approx(cell.limit));
        return;
    }
    CHECK(item.kind == LimitKind::notPermitted);
    CHECK(item.formula.at(sizes) == 0);
    if (!item.shortOnes) return;
    CHECK(item.shortOnes->formula.at(sizes) == Approx(cell.limit));
    CHECK(item.shortOnes->per == 100);
    CHECK(item.shortOnes->allowed(300) == 25);
    CHECK(item.shortOnes->allowed(100) == 25);
    CHECK(item.shortOnes->allowed(40) == 10);
}

} // namespace

TEST_CASE("ISO 5817: every row of plates from 0.5 to 3 mm and above, and its caps, for D, C and B", "[acceptance]") {
    const std::array<Acceptance, 3> levels{shipped("iso5817-d"), shipped("iso5817-c"), shipped("iso5817-b")};
    std::set<std::string> named;
    for (const IsoRow& row : kIsoRows) {
        named.insert(row.imperfection);
        for (size_t level = 0; level < levels.size(); ++level) {
            checkCell(levels[level], row, row.thin[level], kThin);
            checkCell(levels[level], row, row.thick[level], kThick);
            checkCell(levels[level], row, row.huge[level], kHuge);
        }
    }
    std::string letters;
    for (const Acceptance& each : levels) {
        CHECK(each.standard == "ISO 5817");
        CHECK(each.edition == "2014");
        letters += each.level;
        for (const AcceptanceItem& item : each.items)
            CHECK(named.count(item.imperfection) == 1); // no row that the table lacks
    }
    CHECK(letters == "DCB");
}

TEST_CASE("ISO 5817: a plate of exactly 3 mm is a thin one", "[acceptance]") {
    const Acceptance c = shipped("iso5817-c"), b = shipped("iso5817-b");
    const auto fillet = WeldKind::fillet, butt = WeldKind::butt;
    const LimitSizes three{8, 3, 3, 4.2}, above{8, 3, 3.1, 4.2};
    CHECK(shortLimit(c, "insufficient_throat", fillet, three) == Approx(0.2));
    CHECK(shortLimit(c, "insufficient_throat", fillet, above) == Approx(0.6));
    CHECK(shortLimit(c, "undercut", fillet, three) == Approx(0.3));
    CHECK(limitOf(c, "undercut", fillet, above) == Approx(0.31));
    CHECK(limitOf(c, "excess_penetration", butt, three) == Approx(3.4));
    CHECK(limitOf(c, "excess_penetration", butt, above) == 4);
    CHECK(limitOf(c, "joint_gap", fillet, three) == Approx(0.6));
    CHECK(limitOf(c, "joint_gap", fillet, above) == Approx(1.1));
    CHECK_FALSE(itemOf(b, "root_concavity", butt, three).shortOnes);
    CHECK(shortLimit(b, "root_concavity", butt, above) == Approx(0.155));
}

TEST_CASE("AWS D1.1: limits by size of the fillet, plate and face", "[acceptance]") {
    const Acceptance aws = shipped("aws-d1-1-static");
    const auto fillet = WeldKind::fillet;
    const auto sized = [](double leg, double t, double b) { return LimitSizes{b, kNone, t, leg}; };
    CHECK(shortLimit(aws, "leg_too_small", fillet, sized(5, 6, 7)) == 2);
    CHECK(shortLimit(aws, "leg_too_small", fillet, sized(6, 6, 7)) == 2.5);
    CHECK(shortLimit(aws, "leg_too_small", fillet, sized(8, 6, 7)) == 3);
    CHECK(itemOf(aws, "leg_too_small", fillet).shortOnes->allowed(150) == Approx(15));
    CHECK(limitOf(aws, "undercut", fillet, sized(6, 24.9, 7)) == 1);
    CHECK(limitOf(aws, "undercut", fillet, sized(6, 25, 7)) == 2);
    const ShortAllowance undercut = *itemOf(aws, "undercut", fillet).shortOnes;
    CHECK(undercut.formula.at({}) == 2);
    CHECK(undercut.allowed(600) == 50);
    CHECK(undercut.allowed(40) == 40);
    CHECK(limitOf(aws, "convexity", fillet, sized(6, 6, 8)) == 2);
    CHECK(limitOf(aws, "convexity", fillet, sized(6, 6, 9)) == 3);
    CHECK(limitOf(aws, "convexity", fillet, sized(6, 6, 25)) == 5);
    CHECK(limitOf(aws, "excess_weld_metal", WeldKind::butt) == 3);
    CHECK(limitOf(aws, "piping_porosity", fillet) == 10);
    CHECK(itemOf(aws, "piping_porosity", WeldKind::butt).kind == LimitKind::notPermitted);
    // Primary members under cyclic load with the weld across the tension: less undercut, all else as above.
    const Acceptance cyclic = shipped("aws-d1-1-cyclic");
    CHECK(limitOf(cyclic, "undercut", fillet, sized(6, 6, 7)) == 0.25);
    CHECK(limitOf(cyclic, "undercut", fillet, sized(6, 30, 7)) == 0.25);
    CHECK_FALSE(itemOf(cyclic, "undercut", fillet).shortOnes);
    CHECK(limitOf(cyclic, "convexity", fillet, sized(6, 6, 9)) == 3);
    CHECK(cyclic.items.size() + 1 == aws.items.size()); // there undercut has a row for plates from 25 mm
}

TEST_CASE("every shipped acceptance is found by its name, and others are told", "[acceptance]") {
    CHECK(acceptanceNames() == std::vector<std::string>{"aws-d1-1-cyclic", "aws-d1-1-static", "iso5817-b", "iso5817-c",
                                                        "iso5817-d", "solder"});
    for (const std::string& name : acceptanceNames()) {
        INFO(name);
        CHECK(findAcceptance(name).items.size() > 8);
    }
    CHECK_THROWS_WITH(findAcceptance("iso"), test::containsText("'iso'") && test::containsText("iso5817-c"));
    CHECK_THROWS_AS(findAcceptance("nowhere.toml"), InputError);
}

TEST_CASE("a broken acceptance file is told with its line, its key and what is expected", "[acceptance]") {
    const std::string head = "standard = \"S\"\nedition = \"1\"\nlevel = \"L\"\n[[item]]\n";
    const std::string undercut = "imperfection = \"undercut\"\napplies_to = \"fillet\"\n";
    struct Broken {
        std::string text;
        int line;
        std::string key, expected;
    };
    const std::vector<Broken> files{
        {"standard = \"S\"\nedition = \"1\"\n", 1, "level", "a text in quotes"},
        {"standard = \"S\"\nedition = \"1\"\nlevel = \"L\"\n", 1, "item", "at least one [[item]]"},
        {head + "imperfection = \"undercutt\"\n", 5, "imperfection", "undercut"},
        {head + "imperfection = \"undercut\"\napplies_to = \"fillet, groove\"\n", 6, "applies_to",
         "fillet, butt, bead"},
        {head + undercut + "limit = \"below\"\n", 7, "limit", "not_permitted, at_most, at_least"},
        {head + undercut + "limit = \"at_most\"\n", 4, "const_mm", "per_b"},
        {head + undercut + "limit = \"at_most\"\nmax_mm = 1\n", 4, "const_mm", "per_b"},
        {head + undercut + "limit = \"not_permitted\"\nconst_mm = 1\n", 7, "limit", "no numbers"},
        {head + undercut + "limit = \"at_most\"\nper_t = \"x\"\n", 8, "per_t", "a number"},
        {head + undercut + "limit = \"at_most\"\nper_t = 0.1\nper_x = 2\n", 9, "per_x", "per_t"},
        {head + undercut + "limit = \"at_most\"\nper_t = 0.1\nt_above_mm = 3\nt_from_mm = 3\n", 10, "t_from_mm",
         "one of them"},
        {head + undercut + "limit = \"at_most\"\nper_t = 0.1\nt_above_mm = 3\nt_up_to_mm = 2\n", 10, "t_up_to_mm",
         "from 3"},
        {head + undercut + "limit = \"not_permitted\"\n[item.short]\nlength_mm = 25\nper_mm = 100\n", 8, "const_mm",
         "limit of short"},
        {head + undercut + "limit = \"not_permitted\"\n[item.short]\nconst_mm = 1\n", 8, "share", "per_mm"},
        {head + undercut + "limit = \"not_permitted\"\n[item.short]\nconst_mm = 1\nlength_mm = 25\n", 8, "per_mm",
         "together"},
        {head + undercut + "limit = \"not_permitted\"\n[item.short]\nconst_mm = 1\nshare = 2\n", 10, "share", "0 to 1"},
        {head + "imperfection = \"toe_angle\"\napplies_to = \"fillet\"\nlimit = \"at_least\"\nconst_mm = 90\n", 4,
         "const_deg", "the limit"},
        {head + undercut + "limit = \"at_least\"\nconst_mm = 1\n[item.short]\nconst_mm = 1\nshare = 0.1\n", 9, "short",
         "does not fit at_least"},
        {head + undercut + "limit = \"not_permitted\"\ncolour = \"red\"\n", 8, "colour", "known here"},
        {"\nsize = \n", 2, "", ""}};
    const std::filesystem::path file = test::scratchFolder("acceptance") / "school.toml";
    for (const Broken& broken : files) {
        writeTextFileAtomically(file, broken.text);
        INFO(broken.text);
        std::string told;
        try {
            readAcceptance(file);
        } catch (const InputError& fault) {
            told = fault.what();
        }
        CHECK_THAT(told, test::containsText("school.toml:" + std::to_string(broken.line) + ":"));
        CHECK_THAT(told, test::containsText(broken.key));
        CHECK_THAT(told, test::containsText(broken.expected));
    }
    writeTextFileAtomically(file,
                            head + undercut + "limit = \"not_permitted\"\n[item.short]\nconst_mm = 1\nshare = 0.1\n");
    CHECK(findAcceptance(file.string()).items.size() == 1);
}
