// The runtime is killed (kill -9), and the headset is used again when it is back.
#include "tests/support/catch.hpp"
#include "tests/xr/bench.hpp"
#include "xr/headset_connection.hpp"

#include <chrono>
#include <csignal>
#include <thread>

using namespace meltpool;
using namespace meltpool::test;

namespace {

using Clock = std::chrono::steady_clock;

/// One turn of a front end's loop: frames while there is a headset. Answers how long it took.
double turn(xr::HeadsetConnection& link) {
    const auto begin = Clock::now();
    if (link.update() == xr::ConnectionState::running) {
        try {
            stepFrame(*link.headset(), {});
        } catch (const xr::XrFault& fault) {
            link.onFault(fault);
        } catch (const xr::Stalled&) {
            link.onStall();
        }
    } else
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

bool turnUntil(xr::HeadsetConnection& link, xr::ConnectionState state, double seconds, double& longest) {
    for (const auto end = Clock::now() + std::chrono::duration<double>(seconds); Clock::now() < end;) {
        longest = std::max(longest, turn(link));
        if (link.state() == state) return true;
    }
    return false;
}

} // namespace

TEST_CASE("the runtime is killed: the loop goes on within a second and the headset is used again", "[runtime]") {
    benchWindow();
    auto driver = std::make_unique<RemoteDriver>(benchPort());
    driver->send({});
    xr::HeadsetConnection link({.resolutionScale = 0.3f, .samples = 1});
    double longest = 0;
    REQUIRE(turnUntil(link, xr::ConnectionState::running, 10, longest));
    for (int i = 0; i < 20; ++i)
        turn(link);
    REQUIRE(link.state() == xr::ConnectionState::running);
    CHECK(link.openings() == 1);

    const int killed = servicePid();
    REQUIRE(kill(killed, SIGKILL) == 0);
    longest = 0;
    REQUIRE(turnUntil(link, xr::ConnectionState::searching, 5, longest));
    CHECK(longest < 1.0);
    CHECK_FALSE(link.reason().empty());
    CHECK(link.headset() == nullptr);

    // While it is away, no turn of the loop waits.
    longest = 0;
    REQUIRE(turnUntil(link, xr::ConnectionState::running, 20, longest));
    CHECK(longest < 1.0);
    CHECK(servicePid() != killed);
    CHECK(link.openings() == 2);
    driver = std::make_unique<RemoteDriver>(benchPort());
    driver->send({});
    for (int i = 0; i < 20; ++i)
        turn(link);
    CHECK(link.state() == xr::ConnectionState::running);
}
