// Facts of the driver as its version text tells them.
#include "core/gl/context.hpp"
#include "tests/support/catch.hpp"

using namespace meltpool;

TEST_CASE("the version of Mesa is read from OpenGL's version text", "[gl]") {
    CHECK(gl::mesaMajor("4.5 (Core Profile) Mesa 22.3.6") == 22);
    CHECK(gl::mesaMajor("4.6 (Compatibility Profile) Mesa 25.0.7-2+deb13u1") == 25);
    CHECK(gl::mesaMajor("4.6.0 NVIDIA 535.183.01") == 0);
    CHECK(gl::mesaMajor("4.5 Mesa devel") == 0);
    CHECK(gl::mesaMajor("") == 0);
}
