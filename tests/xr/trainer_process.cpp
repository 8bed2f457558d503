#include "tests/xr/trainer_process.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;

/// The program's file and arguments, preceded by the launcher that tests/xr/bench.sh asks for.
std::vector<std::string> launched(const fs::path& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> words;
    if (const char* launch = std::getenv("MELTPOOL_XR_LAUNCH"))
        for (const std::string_view word : splitText(launch, '\n'))
            if (!word.empty()) words.emplace_back(word);
    words.push_back(program.string());
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
}

int start(const std::vector<std::string>& arguments, const fs::path& folder, const std::string& preload) {
    const std::vector<std::string> words = launched(fs::path(MELTPOOL_BINARY_FOLDER) / "bin" / "meltpool", arguments);
    std::vector<char*> pointers;
    for (const std::string& word : words)
        pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    const int pid = fork();
    if (pid != 0) return pid;
    std::signal(SIGHUP, SIG_DFL); // the tests may run under nohup, which children inherit
    if (!folder.empty()) {
        setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
        setenv("XR_CORE_VALIDATION_FILE_NAME", (folder / "validation.txt").c_str(), 1);
    }
    if (!preload.empty()) setenv("LD_PRELOAD", preload.c_str(), 1);
    const int log = open((benchFolder() / "program.log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    dup2(log, 1);
    dup2(log, 2);
    execv(pointers[0], pointers.data());
    _exit(127);
}

int waitForEnd(int pid) {
    int status = 0;
    waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

TrainerProcess::TrainerProcess(fs::path folder, std::vector<std::string> arguments, const std::string& headset,
                               const std::string& preload)
    : folder_(std::move(folder)) {
    fs::create_directories(folder_ / "meltpool");
    writeTextFileAtomically(folder_ / "meltpool" / "settings.toml", "[headset]\nresolution_scale = 0.4\nsamples = 1\n" +
                                                                        headset +
                                                                        "[window]\nwidth = 640\nheight = 480\n");
    arguments.insert(arguments.end(), {"--telemetry", (folder_ / "window.jsonl").string()});
    pid_ = start(arguments, folder_, preload);
}

TrainerProcess::~TrainerProcess() {
    if (alive()) {
        kill(pid_, SIGKILL);
        waitForEnd(pid_);
    }
}

bool TrainerProcess::alive() {
    if (pid_ < 0) return false;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == 0) return true;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    pid_ = -1;
    return false;
}

std::vector<nlohmann::json> TrainerProcess::rows() {
    std::vector<nlohmann::json> rows;
    const fs::path file = folder_ / "window.jsonl";
    if (!fs::exists(file)) return rows;
    const std::string text = readTextFile(file);
    // The last line may be half written.
    const std::string_view whole = std::string_view(text).substr(0, text.rfind('\n') + 1);
    for (const std::string_view line : splitText(whole, '\n'))
        if (!line.empty()) rows.push_back(nlohmann::json::parse(line));
    return rows;
}

nlohmann::json TrainerProcess::now() {
    const fs::path file = folder_ / "window.jsonl";
    if (!fs::exists(file)) return {};
    const std::string text = readTextFile(file);
    const size_t end = text.rfind('\n');
    if (end == std::string::npos) return {};
    const size_t begin = end == 0 ? 0 : text.rfind('\n', end - 1) + 1;
    return nlohmann::json::parse(text.substr(begin, end - begin));
}

bool TrainerProcess::waitFor(const std::function<bool(const nlohmann::json&)>& done,
                             const std::function<void()>& meanwhile) {
    bool came = false;
    waitUntil([&] {
        if (meanwhile) meanwhile();
        const nlohmann::json row = now();
        came = !row.empty() && done(row);
        return came || !alive();
    });
    return came;
}

void TrainerProcess::signal(int number) const {
    if (pid_ >= 0) kill(pid_, number);
}

int TrainerProcess::finish() {
    if (!waitUntil([this] { return !alive(); })) {
        kill(pid_, SIGKILL);
        status_ = waitForEnd(pid_);
        pid_ = -1;
    }
    return status_;
}

int TrainerProcess::stop() {
    if (alive()) signal(SIGTERM);
    return finish();
}

std::string TrainerProcess::misuses() const {
    std::string found;
    for (const std::string_view line : splitText(readTextFile(folder_ / "validation.txt"), '\n'))
        if (line.find("VALID_ERROR") != line.npos || line.find("VALID_WARNING") != line.npos)
            found += std::string(line) + "\n";
    return found;
}

int runTrainer(const std::vector<std::string>& arguments) {
    return waitForEnd(start(arguments, {}, {}));
}

} // namespace meltpool::test
