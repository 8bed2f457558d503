#include "tests/support/gl_fixture.hpp"

#include "core/base/image.hpp"
#include "tests/support/places.hpp"

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace meltpool::test {

namespace fs = std::filesystem;

gl::HeadlessContext& context() {
    static gl::HeadlessContext only;
    return only;
}

gl::ShaderLibrary& shaders() {
    context();
    static gl::ShaderLibrary only(test::sourceFolder() / "shaders");
    return only;
}

fs::path testFolder() {
    return test::sourceFolder() / "tests";
}

fs::path scratchFolder(const std::string& name) {
    struct Root {
        fs::path folder;
        ~Root() { fs::remove_all(folder); }
    };
    static const Root root{fs::temp_directory_path() / ("meltpool-test-" + std::to_string(std::rand()) + "-" +
                                                        std::to_string(reinterpret_cast<size_t>(&root)))};
    const fs::path folder = root.folder / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

bool matchesGolden(const std::string& name, const Image& picture, double farShare) {
    const fs::path golden = testFolder() / "goldens" / (name + ".png");
    const char* approve = std::getenv("MELTPOOL_APPROVE");
    if (approve != nullptr && std::string(approve) == "1") {
        fs::create_directories(golden.parent_path());
        writePng(golden, picture);
        return true;
    }
    const Image expected = readPng(golden);
    const ImageDifference difference = compareImages(expected, picture, 24);
    const bool same = difference.mean < 2.0 && difference.farPixels <= farShare;
    if (!same) {
        const fs::path kept = test::buildFolder() / (fs::path(name).filename().string() + ".actual.png");
        writePng(kept, picture);
        std::fprintf(stderr, "%s differs from its golden: mean %.2f, far pixels %.3f %%, largest %d; kept as %s\n",
                     name.c_str(), difference.mean, difference.farPixels * 100, difference.largest,
                     kept.string().c_str());
    }
    return same;
}

} // namespace meltpool::test
