// A new attempt starts at once: metal, technique and torch are restored without compiling a shader or creating a
// buffer.
#include "app/session/lesson_figures.hpp"
#include "app/session/lesson_session.hpp"
#include "core/training/lesson/recorded_attempt.hpp"
#include "tests/app/small_lessons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <chrono>

using namespace meltpool;

namespace {

int made = 0;    ///< number of calls that make shaders or programs
int buffers = 0; ///< number of calls that make buffers

/// Counts the calls of one OpenGL function during its lifetime.
template <auto Slot, int& calls>
class Counted;

template <class Result, class... Arguments, Result(GLAPIENTRY** Slot)(Arguments...), int& calls>
class Counted<Slot, calls> {
  public:
    Counted() {
        original_ = *Slot;
        *Slot = &call;
    }
    ~Counted() { *Slot = original_; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

  private:
    static Result GLAPIENTRY call(Arguments... arguments) {
        ++calls;
        return original_(arguments...);
    }
    static inline Result(GLAPIENTRY* original_)(Arguments...) = nullptr;
};

struct MakingCalls {
    Counted<&glCompileShader, made> shaders;
    Counted<&glLinkProgram, made> programs;
    Counted<&glCreateBuffers, buffers> memory;
};

/// Welds along the seam for `seconds` of frames.
void weld(LessonSession& session, Controls& controls, double seconds) {
    constexpr double kFrame = 1.0 / 45;
    for (double time = 0; time < seconds; time += kFrame) {
        session.advance(controls, kFrame, nullptr, [&](int, int) {
            TorchSample torch;
            torch.tip = {-0.010f + 8e-3f * static_cast<float>(time), 0.003f, 0};
            torch.orientation = glm::angleAxis(-1.5707963f, glm::vec3(1, 0, 0));
            torch.trigger = 1;
            return torch;
        });
        session.picture().scene(nullptr); // builds the surface, as a frame does
    }
}

} // namespace

TEST_CASE("again puts everything back in under a second and compiles no shader", "[app]") {
    const auto folder = test::scratchFolder("restart");
    Controls controls;
    test::context();
    // A separate shader library leaves the first start something to compile.
    gl::ShaderLibrary shaders(test::testFolder().parent_path() / "shaders");
    MakingCalls counted;
    LessonSession session(shaders, test::smallBead(), [] { return 0.0; });
    session.log().records().use(folder / "weld.csv", "program", "driver");
    session.begin(controls);
    weld(session, controls, 0.6);
    LessonFigures figures;
    fillFigures(figures, session);
    CHECK(figures.molten > 0);
    session.end("start menu");

    CHECK(made > 20); // the first start makes objects, which proves that the count works
    CHECK(buffers > 20);
    session.begin(controls);
    weld(session, controls, 0.6);
    CHECK(session.run().arc().burns());
    made = buffers = 0;
    const auto before = std::chrono::steady_clock::now();
    session.reset(controls);
    session.picture().scene(nullptr);
    glFinish();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    WARN("another attempt began after " << 1000 * seconds << " ms, its surface made");
    CHECK(session.run().steps() == 0);
    CHECK_FALSE(session.run().arc().burns());
    CHECK_FALSE(session.attempt().judged());
    fillFigures(figures, session);
    CHECK(figures.time == 0);
    CHECK(figures.molten == 0);
    weld(session, controls, 0.6);
    CHECK(made == 0);
    CHECK(buffers == 0);
    CHECK(session.run().steps() > 20);
    session.end("start menu");

    // The next attempt equals a fresh start's to the last bit.
    const auto second = readRecordedAttempt(folder / "weld-2.csv"), third = readRecordedAttempt(folder / "weld-3.csv");
    REQUIRE((second && third));
    CHECK(second->rows == third->rows);
    CHECK(second->ended == "reset");
    CHECK(second->stateHash == third->stateHash);
}
