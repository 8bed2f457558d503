// The shipped acceptance files: they hold the standards' numbers, and faults are reported with file, line and key;
// limits in mm and degrees.
#include "core/training/judging/acceptance.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <limits>

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

TEST_CASE("ISO 5817: limits are the table's formulas", "[acceptance]") {
    struct Row {
        const char* imperfection;
        WeldKind kind;
        double d, c, b; ///< limits for b 8, a 4, t 6
    };
    const auto fillet = WeldKind::fillet, butt = WeldKind::butt;
    const std::vector<Row> rows{{"undercut", fillet, 1, 0.5, 0.3},
                                {"excess_weld_metal", butt, 3, 2.2, 1.8},
                                {"convexity", fillet, 3, 2.2, 1.8},
                                {"excess_penetration", butt, 5, 4, 2.6},
                                {"toe_angle", butt, 90, 110, 150},
                                {"toe_angle", fillet, 90, 100, 110},
                                {"overlap", fillet, 1.6, 0, 0},
                                {"excessive_asymmetry", fillet, 2.8, 2.6, 2.1},
                                {"linear_misalignment", butt, 1.5, 0.9, 0.6},
                                {"joint_gap", fillet, 2.2, 1.3, 0.9},
                                {"surface_pore", fillet, 1.2, 0.8, 0},
                                {"crack", fillet, 0, 0, 0},
                                {"lack_of_fusion", butt, 0, 0, 0},
                                {"burn_through", WeldKind::bead, 0, 0, 0}};
    const Acceptance d = shipped("iso5817-d"), c = shipped("iso5817-c"), b = shipped("iso5817-b");
    for (const Row& row : rows) {
        INFO(row.imperfection);
        CHECK(limitOf(d, row.imperfection, row.kind) == Approx(row.d));
        CHECK(limitOf(c, row.imperfection, row.kind) == Approx(row.c));
        CHECK(limitOf(b, row.imperfection, row.kind) == Approx(row.b));
    }
    CHECK(limitOf(c, "excessive_throat", fillet) == Approx(1.8));
    CHECK(limitOf(b, "excessive_throat", fillet) == Approx(1.6));
    for (const AcceptanceItem& item : d.items)
        CHECK(item.imperfection != "excessive_throat"); // level D allows it
    CHECK(itemOf(c, "toe_angle", fillet).kind == LimitKind::atLeast);
    CHECK(itemOf(c, "crack", fillet).kind == LimitKind::notPermitted);
    for (const Acceptance* each : {&d, &c, &b}) {
        CHECK(each->standard == "ISO 5817");
        CHECK(each->edition == "2014");
    }
    CHECK(d.level + c.level + b.level == "DCB");
}

TEST_CASE("ISO 5817: limits have their caps, and thin plates their own", "[acceptance]") {
    const Acceptance d = shipped("iso5817-d"), c = shipped("iso5817-c"), b = shipped("iso5817-b");
    const LimitSizes large{100, 40, 60, 60}, thin{8, 2, 3, 3};
    const auto fillet = WeldKind::fillet, butt = WeldKind::butt;
    CHECK(limitOf(d, "convexity", fillet, large) == 5);
    CHECK(limitOf(c, "convexity", fillet, large) == 4);
    CHECK(limitOf(b, "convexity", fillet, large) == 3);
    CHECK(limitOf(d, "excess_weld_metal", butt, large) == 10);
    CHECK(limitOf(c, "excess_weld_metal", butt, large) == 7);
    CHECK(limitOf(b, "excess_weld_metal", butt, large) == 5);
    CHECK(limitOf(d, "undercut", butt, large) == 1);
    CHECK(limitOf(c, "undercut", butt, large) == 0.5);
    CHECK(limitOf(c, "linear_misalignment", butt, large) == 4);
    CHECK(limitOf(c, "joint_gap", fillet, large) == 3);
    CHECK(limitOf(d, "excess_penetration", butt, thin) == Approx(5.8));
    CHECK(limitOf(c, "excess_penetration", butt, thin) == Approx(3.4));
    CHECK(limitOf(b, "excess_penetration", butt, thin) == Approx(1.8));
    CHECK(shortLimit(d, "undercut", fillet, thin) == Approx(0.6));
    CHECK(shortLimit(c, "undercut", fillet, thin) == Approx(0.3));
    CHECK_FALSE(itemOf(b, "undercut", fillet, thin).shortOnes);
    CHECK(itemOf(b, "undercut", fillet, thin).kind == LimitKind::notPermitted);
}

TEST_CASE("ISO 5817: what only short imperfections may be", "[acceptance]") {
    const Acceptance d = shipped("iso5817-d"), c = shipped("iso5817-c"), b = shipped("iso5817-b");
    const auto fillet = WeldKind::fillet, butt = WeldKind::butt;
    CHECK(shortLimit(d, "root_penetration_missing", butt) == Approx(1.2));
    CHECK_FALSE(itemOf(c, "root_penetration_missing", butt).shortOnes);
    CHECK(shortLimit(d, "incompletely_filled_groove", butt) == Approx(1.5));
    CHECK(shortLimit(c, "incompletely_filled_groove", butt) == Approx(0.6));
    CHECK(shortLimit(b, "incompletely_filled_groove", butt) == Approx(0.3));
    CHECK(shortLimit(d, "root_concavity", butt) == Approx(1.2));
    CHECK(shortLimit(b, "root_concavity", butt) == Approx(0.3));
    CHECK(shortLimit(d, "insufficient_throat", fillet) == Approx(0.7));
    CHECK(shortLimit(c, "insufficient_throat", fillet, {8, 10, 12, 14}) == 1); // maximum of the allowance
    CHECK_FALSE(itemOf(b, "insufficient_throat", fillet).shortOnes);
    const ShortAllowance allowance = *itemOf(c, "insufficient_throat", fillet).shortOnes;
    CHECK(allowance.per == 100);
    CHECK(allowance.allowed(300) == 25);
    CHECK(allowance.allowed(100) == 25);
    CHECK(allowance.allowed(40) == 10);
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
}

TEST_CASE("every shipped acceptance is found by its name, and others are told", "[acceptance]") {
    CHECK(acceptanceNames() ==
          std::vector<std::string>{"aws-d1-1-static", "iso5817-b", "iso5817-c", "iso5817-d", "solder"});
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
