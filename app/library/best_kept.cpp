#include "app/library/best_kept.hpp"

#include "app/library/kept_attempts.hpp"

namespace meltpool {

std::filesystem::path bestKept(const std::filesystem::path& folder, const std::string& lesson,
                               const std::string& personId) {
    std::filesystem::path best;
    int most = -1;
    for (const KeptAttempt& kept : keptRecordings(folder)) { // newest first
        if (kept.lesson != lesson || kept.personId != personId || kept.practice || !kept.score || *kept.score <= most)
            continue;
        most = *kept.score;
        best = kept.file;
    }
    return best;
}

} // namespace meltpool
