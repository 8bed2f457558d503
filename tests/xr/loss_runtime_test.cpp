// Tests a runtime that is killed (kill -9), and the headset's use after its return.
#include "tests/support/catch.hpp"
#include "tests/xr/monado_run.hpp"
#include "xr/headset_connection.hpp"

#include <chrono>
#include <csignal>
#include <thread>

using namespace meltpool;
using namespace meltpool::test;

namespace {

using Clock = std::chrono::steady_clock;

/// Does one turn of a front end's loop: frames while there is a headset. Returns its duration.
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

/// Course of a loop until the link had a state.
struct Turns {
    bool reached = false; ///< false only after kPatience
    int count = 0;
    double longest = 0; ///< s
};

Turns turnUntil(xr::HeadsetConnection& link, xr::ConnectionState state) {
    Turns turns;
    for (const auto end = Clock::now() + std::chrono::duration<double>(kPatience); Clock::now() < end;) {
        turns.longest = std::max(turns.longest, turn(link));
        ++turns.count;
        if (link.state() == state) {
            turns.reached = true;
            break;
        }
    }
    return turns;
}

} // namespace

TEST_CASE("the runtime is killed: the loop goes on without it and the headset is used again", "[runtime]") {
    hiddenWindow();
    auto driver = std::make_unique<RemoteDriver>(driverPort());
    driver->send({});
    xr::HeadsetConnection link({.resolutionScale = 0.3f, .samples = 1});
    REQUIRE(turnUntil(link, xr::ConnectionState::running).reached);
    for (int i = 0; i < 20; ++i)
        turn(link);
    REQUIRE(turnUntil(link, xr::ConnectionState::running).reached);
    CHECK(link.openings() == 1);

    const int killed = servicePid();
    REQUIRE(kill(killed, SIGKILL) == 0);
    const Turns loss = turnUntil(link, xr::ConnectionState::searching);
    REQUIRE(loss.reached);
    CHECK_FALSE(link.reason().empty());
    CHECK(link.headset() == nullptr);

    // The loop turns during the absence, for two seconds at least.
    const Turns absence = turnUntil(link, xr::ConnectionState::running);
    REQUIRE(absence.reached);
    CHECK(absence.count > 5); // turns of 10 ms; a loop that waits for a runtime makes one or two
    WARN("longest turn of the loop: " << loss.longest << " s at the loss, " << absence.longest << " s in the absence, "
                                      << absence.count << " turns");
    CHECK(servicePid() != killed);
    CHECK(link.openings() == 2);
    driver = std::make_unique<RemoteDriver>(driverPort());
    driver->send({});
    for (int i = 0; i < 20; ++i)
        turn(link);
    CHECK(turnUntil(link, xr::ConnectionState::running).reached);
    CHECK(link.openings() == 2);
}
