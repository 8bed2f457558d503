// Parameters as text: input, output, and every error.
#include "core/base/error.hpp"
#include "core/base/parameter.hpp"
#include "tests/support/catch.hpp"

#include <array>
#include <limits>

namespace meltpool {

namespace {

constexpr std::array<std::string_view, 2> kKinds{"metal", "ice"};

struct Sample {
    float rate = 0.1f;
    int count = 3;
    bool on = false;
    int kind = 0;
    glm::vec3 gravity{0, -9.81f, 0};
};

ParameterList describe(Sample& s) {
    return {{"rate", "Rate", "1/s", &s.rate, 0, 2, "none"},
            {"count", "Count", "", &s.count, 1, 8, "none"},
            {"on", "On", "", &s.on, 0, 1, "none"},
            {"kind", "Kind", "", &s.kind, 0, 1, "none", kKinds},
            {"gravity", "Gravity", "m/s2", &s.gravity, -100, 100, "none"}};
}

} // namespace

TEST_CASE("a parameter's text reads back to the same bits") {
    Sample s;
    const ParameterList list = describe(s);
    for (const float value : {0.1f, 1.0f / 3.0f, 1e-7f, 2.0f}) {
        s.rate = value;
        const std::string text = parameterText(list[0]);
        s.rate = 0;
        setParameter(list, "rate", text, "test");
        CHECK(s.rate == value);
    }
    setParameter(list, "gravity", "1, -2.5,3e-1", "test");
    CHECK(s.gravity == glm::vec3(1, -2.5f, 0.3f));
    setParameter(list, "kind", "ice", "test");
    CHECK(s.kind == 1);
    CHECK(parameterText(list[3]) == "ice");
}

TEST_CASE("a wrong parameter is refused in words and leaves the value alone") {
    Sample s;
    const ParameterList list = describe(s);
    CHECK_THROWS_WITH(setParameter(list, "rat", "1", "--set"),
                      test::containsText("unknown key 'rat'; did you mean 'rate'? Expected one of rate, count"));
    CHECK_THROWS_WITH(setParameter(list, "rate", "3", "--set"), test::containsText("from 0 to 2 (1/s)"));
    for (const char* text : {"", "nan", "inf", "1x", "0x1", "1,0"})
        CHECK_THROWS_AS(setParameter(list, "rate", text, "--set"), InputError);
    for (const char* text : {"2.5", "0", "9", "99999999999999999999"})
        CHECK_THROWS_AS(setParameter(list, "count", text, "--set"), InputError);
    CHECK_THROWS_AS(setParameter(list, "kind", "wood", "--set"), InputError);
    CHECK_THROWS_AS(setParameter(list, "gravity", "1,2", "--set"), InputError);
    CHECK_THROWS_AS(setParameter(list, "gravity", "1,2,1000", "--set"), InputError);
    CHECK(s.rate == 0.1f);
    CHECK(s.count == 3);
    CHECK(s.gravity.y == -9.81f);
}

} // namespace meltpool
