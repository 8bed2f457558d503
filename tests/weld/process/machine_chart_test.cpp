// Makers' charts: reading with its refusals, the shipped rows, and the rows that fit a joint.
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/weld/process/machine_chart.hpp"
#include "core/weld/process/wire_arc.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <algorithm>
#include <set>

using namespace meltpool;
using namespace meltpool::test;

namespace {

const std::string kHead = "id,source,mark,process,joint,position,metal,thickness_mm,diameter_mm,gas,feed_m_min,voltage,"
                          "current,tip_distance_mm\n";

std::vector<ChartRow> readRows(const std::string& rows) {
    const auto file = scratchFolder("chart") / "chart.csv";
    writeTextFileAtomically(file, kHead + rows);
    return readChart(file);
}

const std::vector<ChartRow>& shipped() {
    static const std::vector<ChartRow> rows = readCharts(sourceFolder() / "app" / "data" / "charts");
    return rows;
}

const ChartRow& shippedRow(std::string_view id) {
    const auto found = std::find_if(shipped().begin(), shipped().end(), [&](const ChartRow& r) { return r.id == id; });
    REQUIRE(found != shipped().end());
    return *found;
}

/// Returns the ids of the shipped rows that fit, best first.
std::vector<std::string> fitting(WorkpieceKind kind, float thickness, float wire, GasKind gas, float feed = 5.8F) {
    WorkpieceParameters plates;
    plates.kind = static_cast<int>(kind);
    plates.thicknessMm = thickness;
    ProcessSettings process;
    auto& gmaw = process.choose<Gmaw>();
    gmaw.wireDiameterMm = wire;
    gmaw.gas = static_cast<int>(gas);
    gmaw.wireFeedMPerMin = feed;
    std::vector<std::string> ids;
    for (const StartingValues& values : fittingStartingValues(shipped(), plates, process))
        ids.push_back(values.row->id);
    return ids;
}

} // namespace

TEST_CASE("a chart's cells become SI ranges", "[weld][chart]") {
    const auto rows = readRows("A,\"Maker, p. 3\",read,gmaw,tee/lap,2F,s235,3.2,0.9-1.2,co2/ar_co2,6,19-21,130-170,10\n"
                               "B,shop,memory,smaw,any,any,s235,,3.2,,,,115,\n");
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].source == "Maker, p. 3");
    CHECK(rows[0].read);
    CHECK(rows[0].joints == std::vector<std::string>{"tee", "lap"});
    CHECK(rows[0].thickness->least == Approx(3.2e-3));
    CHECK(rows[0].thickness->most == rows[0].thickness->least);
    CHECK(rows[0].diameter->most == Approx(1.2e-3));
    CHECK(rows[0].voltage->middle() == 20);
    CHECK(rows[0].feed->middle() == Approx(0.1));
    CHECK(rows[0].isFor(shieldingGas(GasKind::co2)));
    CHECK_FALSE(rows[0].isFor(shieldingGas(GasKind::ar)));
    CHECK_FALSE(rows[1].read);
    CHECK(rows[1].joints.empty());
    CHECK_FALSE(rows[1].voltage.has_value());
    CHECK(rows[1].gases.empty());
}

TEST_CASE("a chart's faults are refused with file, line and the expected value", "[weld][chart]") {
    const auto refusal = [](const std::string& rows) {
        try {
            readRows(rows);
        } catch (const InputError& fault) {
            return std::string(fault.what());
        }
        return std::string("nothing");
    };
    CHECK_THAT(refusal("A,m,read,gmaw,tee,2F,s235,3,1,helium,,20,150,\n"),
               containsText("chart.csv:2: gas is 'helium'; expected any, or some of ar_co2, co2, ar_o2, ar, none"));
    CHECK_THAT(refusal("A,m,read,gmaw,tea,2F,s235,3,1,co2,,20,150,\n"), containsText("joint is 'tea'"));
    CHECK_THAT(refusal("A,m,read,gmaw,tee,2H,s235,3,1,co2,,20,150,\n"), containsText("position is '2H'"));
    CHECK_THAT(refusal("A,m,read,mig,tee,2F,s235,3,1,co2,,20,150,\n"), containsText("process is 'mig'"));
    CHECK_THAT(refusal("A,m,seen,gmaw,tee,2F,s235,3,1,co2,,20,150,\n"), containsText("one of read, memory"));
    CHECK_THAT(refusal("A,m,read,gmaw,tee,2F,s235,3,1,co2,,21-20,150,\n"),
               containsText("voltage is '21-20'; expected a number from 0, or a range such as 19-21"));
    CHECK_THAT(refusal("A,m,read,gmaw,tee,2F,s235,3,1,co2,,20,,\n"), containsText("neither feed_m_min nor current"));
    CHECK_THAT(refusal("A,m,read,gmaw,tee,2F,s235,3,1,co2,,20,150,\nA,m,read,gmaw,tee,2F,s235,3,1,co2,,20,150,\n"),
               containsText("chart.csv:3: id is 'A'; expected another name"));
    const auto file = scratchFolder("chart-columns") / "chart.csv";
    writeTextFileAtomically(file, "id,source,volts\n");
    CHECK_THROWS_WITH(readChart(file), containsText("chart.csv:1: has the column 'volts'; expected some of id"));
}

TEST_CASE("the shipped rows have sources, shipped metals and settings of their process", "[weld][chart]") {
    CHECK(shipped().size() >= 80);
    std::set<std::string> metals;
    for (const auto& file : materialFiles(sourceFolder() / "app" / "data" / "materials"))
        metals.insert(file.stem().string());
    for (const ChartRow& row : shipped()) {
        INFO(row.id);
        CHECK(metals.contains(row.metal));
        CHECK(row.gases.empty() == (row.process == Smaw::kName));
        if (row.process == Gmaw::kName) {
            CHECK(row.voltage.has_value());
            CHECK(row.diameter.has_value());
            CHECK_FALSE(row.transfer.empty());
        } else {
            CHECK(row.current.has_value());
            CHECK_FALSE(row.feed.has_value());
        }
    }
    CHECK(shippedRow("PAN-FM5").voltage == ChartRange{19.5, 21});
    CHECK_FALSE(shippedRow("MEM-corner").read);
}

TEST_CASE("a row without a feed takes the feed that melts at its current", "[weld][chart]") {
    const StartingValues values = startingValues(shippedRow("PAN-FM5"), 1.2e-3, &shieldingGas(GasKind::arCo2), 15e-3);
    REQUIRE(values.feed.has_value());
    CHECK(values.feedFromCurrent);
    CHECK(values.gasVoltage == 0);
    CHECK(values.voltage == ChartRange{19.5, 21});
    // The wire is 10 mm long less the arc, of which 0.42 mm burn at 130 A and 1.66 mm at 140 A.
    const WireMelting melting = WireMelting::steel(1.2e-3);
    CHECK(values.feed->least == Approx(melting.speed(130, 10e-3 - 0.42e-3)).epsilon(1e-6));
    CHECK(values.feed->most == Approx(melting.speed(140, 10e-3 - 1.66e-3)).epsilon(1e-6));
    CHECK(values.feed->middle() * 60 == Approx(3).margin(0.15));
    // A row with its feed keeps it.
    const StartingValues given = startingValues(shippedRow("MEM-corner"), 1e-3, &shieldingGas(GasKind::arCo2), 15e-3);
    CHECK_FALSE(given.feedFromCurrent);
    CHECK(given.feed->middle() == Approx(4.0 / 60));
}

TEST_CASE("a row for carbon dioxide serves for the mix with less voltage, and the other way round", "[weld][chart]") {
    const StartingValues mixed = startingValues(shippedRow("OTC-HF5"), 1.2e-3, &shieldingGas(GasKind::arCo2), 12e-3);
    CHECK(mixed.gasVoltage == -1.5);
    CHECK(mixed.voltage == ChartRange{17.5, 19.5});
    const StartingValues co2 = startingValues(shippedRow("PAN-FM5"), 1.2e-3, &shieldingGas(GasKind::co2), 12e-3);
    CHECK(co2.voltage == ChartRange{21, 22.5});
    // An arc in another gas of equal length has equal current, and so equal feed.
    const StartingValues own = startingValues(shippedRow("PAN-FM5"), 1.2e-3, &shieldingGas(GasKind::arCo2), 12e-3);
    CHECK(co2.feed->middle() == Approx(own.feed->middle()).epsilon(1e-9));
}

TEST_CASE("rows fit by joint, position, thickness, wire and gas, the best first", "[weld][chart]") {
    using enum WorkpieceKind;
    CHECK(fitting(Tee, 3, 1.2F, GasKind::arCo2) ==
          std::vector<std::string>{"PAN-FM5", "OTC-HF5", "LG-3.4-1.1", "MIL-P1.14", "MIL-S1.14"});
    CHECK(fitting(Tee, 3, 1.2F, GasKind::co2).front() == "OTC-HF5");
    CHECK(fitting(Lap, 3, 1.2F, GasKind::arCo2).front() == "OTC-LAP5");
    CHECK(fitting(Butt, 3, 1, GasKind::arCo2).front() == "OTC-BM5");
    CHECK(fitting(Corner, 3, 1, GasKind::arCo2) == std::vector<std::string>{"MEM-corner"});
    CHECK(fitting(Plate, 6, 1.2F, GasKind::arCo2) == std::vector<std::string>{"MIL-P1.14", "MIL-S1.14"});
    // A range of the wire for the transfer that is set comes first: 180 A dip, 290 A spray.
    CHECK(fitting(Plate, 6, 1.2F, GasKind::arCo2, 4.5F) == std::vector<std::string>{"MIL-S1.14", "MIL-P1.14"});
    CHECK(fitting(Plate, 6, 1.2F, GasKind::arCo2, 9) == std::vector<std::string>{"MIL-P1.14", "MIL-S1.14"});
    CHECK(fitting(Tee, 3, 1.2F, GasKind::ar).empty()); // no chart has argon for steel
    CHECK(fitting(Butt, 40, 1, GasKind::arCo2).empty());
}

TEST_CASE("rows of other processes fit by electrode and metal", "[weld][chart]") {
    WorkpieceParameters plates;
    plates.kind = static_cast<int>(WorkpieceKind::Tee);
    plates.thicknessMm = 6;
    ProcessSettings stick;
    stick.choose<Smaw>().electrode = 1; // e7018
    const auto fits = fittingStartingValues(shipped(), plates, stick);
    REQUIRE(fits.size() == 2);
    CHECK(fits[0].row->id == "SM-H1");
    CHECK(fits[0].current == ChartRange{115, 125});
    CHECK_FALSE(fits[0].feed.has_value());
    ProcessSettings tungsten;
    tungsten.choose<Gtaw>();
    plates.kind = static_cast<int>(WorkpieceKind::Butt);
    plates.thicknessMm = 3;
    plates.metal = "304";
    const auto butt = fittingStartingValues(shipped(), plates, tungsten);
    REQUIRE(butt.size() == 1);
    CHECK(butt[0].row->id == "ES-Bst3.2");
}

TEST_CASE("a folder's charts are read together, and none is no fault", "[weld][chart]") {
    const auto folder = scratchFolder("charts");
    writeTextFileAtomically(folder / "b.csv", kHead + "B,m,read,gmaw,tee,2F,s235,3,1,co2,,20,150,\n");
    writeTextFileAtomically(folder / "a.csv", kHead + "A,m,read,gmaw,tee,2F,s235,3,1,co2,,20,150,\n");
    writeTextFileAtomically(folder / "notes.txt", "not a chart");
    const auto rows = readCharts(folder);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].id == "A");
    CHECK(rows[1].id == "B");
    CHECK(readCharts(folder / "missing").empty());
}
