#include "tests/app/program.hpp"

#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/places.hpp"

#include <cstdlib>

#include <sys/wait.h>

namespace meltpool::test {

namespace {

/// The tracer of the leak sanitizer occasionally crashes when a program with threads ends (google/sanitizers, issue
/// 1353). It prints a message about the crash, reports no leak, and replaces the program's exit code by its own.
bool leakCheckCrashed(const Outcome& outcome) {
    return outcome.errors.find("LeakSanitizer has encountered a fatal error") != std::string::npos;
}

Outcome runOnce(const std::string& command, const std::filesystem::path& kept) {
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.output = readTextFile(kept / "output");
    outcome.errors = readTextFile(kept / "errors");
    return outcome;
}

} // namespace

Outcome runMeltpool(const std::string& arguments, const std::string& before, const std::filesystem::path& program) {
    static const std::filesystem::path kept = scratchFolder("program");
    const std::filesystem::path built = test::buildFolder() / "bin" / "meltpool";
    const std::filesystem::path binary = program.empty() ? built : program;
    const std::string command = before + " '" + binary.string() + "' " + arguments + " >'" +
                                (kept / "output").string() + "' 2>'" + (kept / "errors").string() + "'";
    Outcome outcome = runOnce(command, kept);
    if (!leakCheckCrashed(outcome)) return outcome;
    WARN("the leak check crashed in its own tracer; the program runs once more");
    return runOnce(command, kept);
}

Outcome runUntilRecorded(const std::string& arguments, const std::filesystem::path& telemetry,
                         const std::string& before) {
    const std::filesystem::path script = scratchFolder("until") / "stop.sh";
    writeTextFileAtomically(script, "\"$@\" & pid=$!\n"
                                    "tries=0\n"
                                    "while [ $tries -lt 3000 ]; do\n"
                                    "  rows=$(cat \"$RECORD\" 2>/dev/null | wc -l)\n"
                                    "  [ \"$rows\" -gt 50 ] && break\n"
                                    "  sleep 0.1; tries=$((tries + 1))\n"
                                    "done\n"
                                    "kill -TERM $pid; wait $pid\n");
    return runMeltpool(arguments, before + " RECORD='" + telemetry.string() + "' sh '" + script.string() + "'");
}

Outcome runBeside(const std::string& first, const std::string& signal, const std::filesystem::path& telemetry,
                  const std::string& second) {
    const std::filesystem::path built = test::buildFolder() / "bin" / "meltpool";
    const std::filesystem::path script = scratchFolder("beside") / "beside.sh";
    writeTextFileAtomically(script, "rm -f '" + telemetry.string() + "'\n" + built.string() + " " + first +
                                        " >/dev/null 2>&1 & pid=$!\n"
                                        "tries=0\n"
                                        "while [ $tries -lt 3000 ]; do\n"
                                        "  rows=$(cat '" +
                                        telemetry.string() +
                                        "' 2>/dev/null | wc -l)\n"
                                        "  [ \"$rows\" -gt 50 ] && break\n"
                                        "  sleep 0.1; tries=$((tries + 1))\n"
                                        "done\n"
                                        "\"$@\"; code=$?\n"
                                        "kill -" +
                                        signal + " $pid; wait $pid 2>/dev/null\nexit $code\n");
    return runMeltpool(second, "sh '" + script.string() + "'");
}

} // namespace meltpool::test
