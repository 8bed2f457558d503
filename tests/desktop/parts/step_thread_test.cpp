// Tests the thread that makes the metal's steps while a picture is drawn, without a window.
#include "app/desktop/step_thread.hpp"
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

class FakeContext final : public StepContext {
  public:
    FakeContext(Calls& calls, bool works) : calls_(calls), works_(works) {}
    ~FakeContext() override { calls_.destroyed = true; }
    bool enter() override {
        calls_.entered = std::this_thread::get_id();
        return works_;
    }
    void leave() override { calls_.left = std::this_thread::get_id(); }
    gl::ShaderLibrary& shaders() override { return shaders_; }

  private:
    Calls& calls_;
    bool works_;
    gl::ShaderLibrary shaders_{"nowhere"};
};

std::unique_ptr<StepContext> fake(Calls& calls, bool works = true) {
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
            while (!goes) // until the other thread has continued
                std::this_thread::yield();
            ++works;
        });
        goes = true;
        thread.wait();
        REQUIRE(works == frame);
    }
    thread.wait(); // no work was begun
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
    CHECK_FALSE(StepThread(fake(calls, false)).usable());
    CHECK(calls.destroyed);
    CHECK(calls.left == std::thread::id()); // a context that was not entered is not left
}

TEST_CASE("work is run on the thread of the steps at once, after what was begun") {
    Calls calls;
    StepThread thread(fake(calls));
    CHECK_FALSE(thread.here());
    std::vector<int> order;
    thread.begin([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        order.push_back(1);
    });
    bool there = false;
    thread.run([&] {
        order.push_back(2);
        thread.run([&] { // a plain call on the thread itself
            order.push_back(3);
            there = thread.here();
        });
    });
    CHECK(order == std::vector{1, 2, 3});
    CHECK(there);
    thread.wait();
}

TEST_CASE("a fault of what is run is thrown there, one of what was begun where that is waited for") {
    Calls calls;
    StepThread thread(fake(calls));
    thread.begin([] { throw RuntimeFault("the steps"); });
    CHECK_THROWS_AS(thread.run([] { throw InputError("what was run"); }), InputError);
    thread.run([] {});
    CHECK_THROWS_AS(thread.wait(), RuntimeFault);
    thread.wait();
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
