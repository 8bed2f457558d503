#include "app/platform/progress_bar.hpp"

#include "app/platform/say.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace meltpool {

namespace {

constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kRhythm(100);

bool errorIsTerminal() {
#ifdef _WIN32
    return _isatty(2) != 0;
#else
    return isatty(2) != 0;
#endif
}

} // namespace

std::string progressLine(const std::string& what, double share, double seconds) {
    const double done = std::clamp(share, 0.0, 1.0);
    const int filled = static_cast<int>(done * kWidth);
    std::string line = what + "  [" + std::string(static_cast<size_t>(filled), '#') +
                       std::string(static_cast<size_t>(kWidth - filled), '.') + "]  " +
                       std::to_string(static_cast<int>(done * 100)) + " %";
    // Earlier the estimate would be too uncertain.
    if (done > 0.02 && seconds > 1)
        line += ", " + std::to_string(static_cast<long>(std::ceil(seconds / done - seconds))) + " s left";
    return line;
}

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)), terminal_(errorIsTerminal() && !isQuiet()) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double done, double whole) {
    const auto now = Clock::now();
    if (!terminal_ || now < next_) return;
    next_ = now + kRhythm;
    drawn_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::fprintf(stderr, "\r\033[K%s", progressLine(what_, whole > 0 ? done / whole : 1, seconds).c_str());
    std::fflush(stderr);
}

} // namespace meltpool
