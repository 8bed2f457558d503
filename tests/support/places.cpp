#include "tests/support/places.hpp"

namespace meltpool::test {

std::filesystem::path sourceFolder() {
    return MELTPOOL_SOURCE_FOLDER;
}

std::filesystem::path buildFolder() {
    return MELTPOOL_BINARY_FOLDER;
}

} // namespace meltpool::test
