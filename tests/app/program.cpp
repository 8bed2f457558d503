#include "tests/app/program.hpp"

#include "core/base/text.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdlib>

#include <sys/wait.h>

namespace meltpool::test {

Outcome runMeltpool(const std::string& arguments, const std::string& before, const std::filesystem::path& program) {
    static const std::filesystem::path kept = scratchFolder("program");
    const std::filesystem::path built = std::filesystem::path(MELTPOOL_BINARY_FOLDER) / "bin" / "meltpool";
    const std::filesystem::path binary = program.empty() ? built : program;
    const std::string command = before + " '" + binary.string() + "' " + arguments + " >'" +
                                (kept / "output").string() + "' 2>'" + (kept / "errors").string() + "'";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.output = readTextFile(kept / "output");
    outcome.errors = readTextFile(kept / "errors");
    return outcome;
}

} // namespace meltpool::test
