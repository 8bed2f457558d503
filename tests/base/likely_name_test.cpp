// Misspelled names: edit distance of two words, and the known name that is meant.
#include "core/base/likely_name.hpp"
#include "tests/support/catch.hpp"

namespace meltpool {

TEST_CASE("the distance of two words counts inserted, removed, changed and exchanged letters") {
    CHECK(editDistance("", "") == 0);
    CHECK(editDistance("", "abc") == 3);
    CHECK(editDistance("abc", "") == 3);
    CHECK(editDistance("voltage", "voltage") == 0);
    CHECK(editDistance("voltage", "votlage") == 1);
    CHECK(editDistance("votlage", "voltage") == 1);
    CHECK(editDistance("kitten", "sitting") == 3);
    CHECK(editDistance("ca", "abc") == 3); // by alignment; an exchanged pair is not changed again
}

TEST_CASE("a misspelled name is recognised, and a strange or ambiguous one is not") {
    const std::vector<std::string> known{"tee-fillet", "gmaw-bead", "gtaw-bead", "lap-2f", "voltage"};
    CHECK(likelyName("tee-filet", known) == "tee-fillet");
    CHECK(likelyName("Tee-Fillet", known) == "tee-fillet");
    CHECK(likelyName("votlage", known) == "voltage");
    CHECK(likelyName("gmaw-baed", known) == "gmaw-bead");
    CHECK(likelyName("tee", known) == "tee-fillet"); // a unique prefix
    CHECK(likelyName("g", known).empty());           // a prefix of two names
    CHECK(likelyName("gxaw-bead", known).empty());   // equally near to both
    CHECK(likelyName("knitting", known).empty());
    CHECK(likelyName("", known).empty());
    CHECK(likelyName("lap", {}).empty());
    CHECK(likelyName(std::string(100000, 'v'), known).empty());
}

TEST_CASE("a refusal asks for the likely name before it lists all") {
    const std::vector<std::string> known{"speed", "count"};
    CHECK(expectedNames("spede", known) == "; did you mean 'speed'? Expected one of speed, count");
    CHECK(expectedNames("colour", known) == "; expected one of speed, count");
    CHECK(expectedNames("conut", known, "known here: ") == "; did you mean 'count'? Known here: speed, count");
}

} // namespace meltpool
