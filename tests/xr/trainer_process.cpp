#include "tests/xr/trainer_process.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/places.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>

namespace meltpool::test {

namespace {

namespace fs = std::filesystem;

/// Pictures with which a software driver keeps pace.
const std::string kSmallPictures = "resolution_scale = 0.4\nsamples = 1\n";

/// Returns the program's file and arguments, preceded by the launcher that tests/xr/run_on_monado.sh requests.
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
    const std::vector<std::string> words = launched(test::buildFolder() / "bin" / "meltpool", arguments);
    std::vector<char*> pointers;
    for (const std::string& word : words)
        pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    const int pid = fork();
    if (pid != 0) return pid;
    std::signal(SIGHUP, SIG_DFL); // the tests may run under nohup, which children inherit
    if (!folder.empty()) {
        setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
        setenv("XDG_DATA_HOME", folder.c_str(), 1);
        setenv("XR_CORE_VALIDATION_FILE_NAME", (folder / "validation.txt").c_str(), 1);
    }
    if (!preload.empty()) setenv("LD_PRELOAD", preload.c_str(), 1);
    const int log = open((runFolder() / "program.log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
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
                               const std::string& preload, const std::string& window)
    : folder_(std::move(folder)), rows_(folder_ / "window.jsonl") {
    fs::create_directories(folder_ / "meltpool");
    writeTextFileAtomically(folder_ / "meltpool" / "settings.toml",
                            "[headset]\n" + (headset.starts_with("resolution_scale") ? "" : kSmallPictures) + headset +
                                "[window]\nwidth = 640\nheight = 480\n" + window);
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
    std::streamoff at = 0;
    for (nlohmann::json row = rows_.read(at); row.is_object(); row = rows_.read(at))
        rows.push_back(std::move(row));
    return rows;
}

nlohmann::json TrainerProcess::now() {
    return rows_.newest();
}

bool TrainerProcess::waitFor(const std::function<bool(const nlohmann::json&)>& done,
                             const std::function<void()>& meanwhile) {
    std::streamoff at = rows_.newestBegin();
    bool came = false;
    waitUntil([&] {
        if (meanwhile) meanwhile();
        const bool ended = !alive(); // read first, so that no row is left out
        for (nlohmann::json row = rows_.read(at); row.is_object(); row = rows_.read(at))
            if (done(row)) return came = true;
        return ended;
    });
    if (!came && !alive()) UNSCOPED_INFO("the program has ended with status " << status_);
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
