// Pictures stored for the next start: found again bit by bit, never under another key, never when damaged.
#include "core/render/look/environment.hpp"
#include "core/render/look/kept_picture.hpp"
#include "shaders/shared/render.h"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"

#include <fstream>
#include <vector>

namespace meltpool {

namespace {

namespace fs = std::filesystem;

std::vector<std::byte> smallPicture() {
    std::vector<std::byte> picture(1000);
    for (size_t i = 0; i < picture.size(); ++i)
        picture[i] = static_cast<std::byte>(i % 251);
    return picture;
}

void changeByte(const fs::path& file, std::streamoff at) {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekg(at);
    const int old = bytes.get();
    bytes.seekp(at);
    bytes.put(static_cast<char>(old ^ 1));
}

/// Returns all levels of an environment as the driver reads them back.
std::vector<GLuint> texelsOf(const Environment& environment) {
    const gl::Texture& room = environment.texture();
    std::vector<GLuint> all;
    for (int level = 0; level < ENVIRONMENT_LEVELS; ++level) {
        const auto edge = static_cast<size_t>(room.shape().width >> level);
        std::vector<GLuint> texels(6 * edge * edge);
        glGetTextureImage(room.name(), level, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV,
                          static_cast<GLsizei>(texels.size() * sizeof(GLuint)), texels.data());
        all.insert(all.end(), texels.begin(), texels.end());
    }
    return all;
}

} // namespace

TEST_CASE("a kept picture is found again under its key alone") {
    const fs::path file = test::scratchFolder("kept-picture") / "new" / "picture.bin";
    const auto picture = smallPicture();
    CHECK_FALSE(keptPicture(file, 7, picture.size()));
    keepPicture(file, 7, picture);
    CHECK(keptPicture(file, 7, picture.size()) == picture);
    CHECK_FALSE(keptPicture(file, 8, picture.size()));
    CHECK_FALSE(keptPicture(file, 7, picture.size() - 1));
}

TEST_CASE("a damaged kept picture counts as none") {
    const fs::path file = test::scratchFolder("damaged-picture") / "picture.bin";
    const auto picture = smallPicture();
    for (const std::streamoff at : {std::streamoff(0), std::streamoff(9), std::streamoff(500), std::streamoff(1015)}) {
        keepPicture(file, 7, picture);
        changeByte(file, at);
        CAPTURE(at);
        CHECK_FALSE(keptPicture(file, 7, picture.size()));
    }
    keepPicture(file, 7, picture);
    fs::resize_file(file, 600);
    CHECK_FALSE(keptPicture(file, 7, picture.size()));
}

TEST_CASE("nothing is kept where there is no room for it, and nothing fails") {
    const fs::path folder = test::scratchFolder("no-folder");
    std::ofstream(folder / "taken") << "a file where a folder is wanted";
    keepPicture(folder / "taken" / "picture.bin", 7, smallPicture());
    CHECK_FALSE(keptPicture(folder / "taken" / "picture.bin", 7, smallPicture().size()));
}

TEST_CASE("a workshop that was kept has the bits of the painted one, and one of other shaders is painted anew") {
    const fs::path folder = test::scratchFolder("kept-workshop");
    const auto painted = texelsOf(Environment(test::shaders(), {}, 64));
    CHECK(texelsOf(Environment(test::shaders(), folder, 64)) == painted);
    REQUIRE(fs::is_regular_file(folder / "workshop.bin"));

    const fs::path shaders = test::scratchFolder("other-shaders");
    fs::copy(test::shaders().root(), shaders, fs::copy_options::recursive);
    const auto written = fs::last_write_time(folder / "workshop.bin");
    {
        // Equal texts in another folder are found and not written again.
        gl::ShaderLibrary same(shaders);
        CHECK(texelsOf(Environment(same, folder, 64)) == painted);
        CHECK(fs::last_write_time(folder / "workshop.bin") == written);
    }
    std::ofstream(shaders / "render" / "workshop.frag", std::ios::app) << "\n// another edition\n";
    gl::ShaderLibrary other(shaders);
    CHECK(texelsOf(Environment(other, folder, 64)) == painted);
    CHECK(fs::last_write_time(folder / "workshop.bin") != written);
}

} // namespace meltpool
