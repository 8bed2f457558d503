// The thread that makes the metal's steps beside a picture, without a window.
#include "app/desktop/steps/step_thread.hpp"
#include "core/base/error.hpp"
#include "core/gl/order.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <atomic>
#include <stdexcept>

namespace meltpool {

namespace {

struct Calls {
    std::thread::id entered, left;
    bool destroyed = false;
};

class FakeContext final : public SharingContext {
  public:
    FakeContext(Calls& calls, bool works) : calls_(calls), works_(works) {}
    ~FakeContext() override { calls_.destroyed = true; }
    bool enter() override {
        calls_.entered = std::this_thread::get_id();
        return works_;
    }
    void leave() override { calls_.left = std::this_thread::get_id(); }

  private:
    Calls& calls_;
    bool works_;
};

std::unique_ptr<SharingContext> fake(Calls& calls, bool works = true) {
    return std::make_unique<FakeContext>(calls, works);
}

} // namespace

TEST_CASE("steps are made on a thread that has its context from its start to its end") {
    Calls calls;
    std::thread::id worked;
    {
        StepThread thread(fake(calls));
        REQUIRE(thread.usable());
        thread.begin([&] { worked = std::this_thread::get_id(); });
        thread.wait();
        CHECK(worked == calls.entered);
        CHECK(worked != std::this_thread::get_id());
        CHECK(thread.seconds() >= thread.waited());
        CHECK_FALSE(calls.destroyed);
    }
    CHECK(calls.left == worked);
    CHECK(calls.destroyed);
}

TEST_CASE("the thread of the steps works while the other one goes on, and each work once") {
    Calls calls;
    StepThread thread(fake(calls));
    std::atomic<bool> goes{false};
    int works = 0;
    for (int frame = 1; frame <= 200; ++frame) {
        goes = false;
        thread.begin([&] {
            while (!goes) // until the other thread has gone on
                std::this_thread::yield();
            ++works;
        });
        goes = true;
        thread.wait();
        REQUIRE(works == frame);
    }
    thread.wait(); // nothing was begun
    CHECK(works == 200);
}

TEST_CASE("a fault of the steps reaches the window's thread, and the next steps are made") {
    Calls calls;
    StepThread thread(fake(calls));
    thread.begin([] { throw RuntimeFault("the metal is gone"); });
    CHECK_THROWS_AS(thread.wait(), RuntimeFault);
    bool made = false;
    thread.begin([&] { made = true; });
    thread.wait();
    CHECK(made);
}

TEST_CASE("work that is under way when the window closes is finished first") {
    Calls calls;
    bool made = false;
    {
        StepThread thread(fake(calls));
        thread.begin([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            made = true;
        });
    }
    CHECK(made);
    CHECK(calls.destroyed);
}

TEST_CASE("without a context no steps are made beside the picture") {
    Calls calls;
    CHECK_FALSE(StepThread(nullptr).usable());
    CHECK_FALSE(StepThread(fake(calls, false)).usable());
    CHECK(calls.destroyed);
}

TEST_CASE("only the thread of the steps leaves fences out") {
    test::context();
    Calls calls;
    StepThread thread(fake(calls));
    GLsync there = nullptr;
    thread.begin([&] { there = gl::fence(); }); // this thread has no context: a call would crash
    thread.wait();
    CHECK(there == nullptr);
    const GLsync here = gl::fence();
    CHECK(here != nullptr);
    glDeleteSync(here);
}

} // namespace meltpool
