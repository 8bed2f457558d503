// `meltpool history`: results of bench and validate over time, as one page.
#include "app/commands/commands.hpp"
#include "app/platform/say.hpp"
#include "app/report/history_page.hpp"
#include "core/base/output_file.hpp"
#include "core/base/words.hpp"

#include <cstdio>

namespace meltpool {

void writeHistory(const HistoryRequest& request) {
    const ResultHistory history = readResultHistory(request.folder);
    for (const std::filesystem::path& file : history.leftOut)
        std::fprintf(stderr, "meltpool: %s\n", phrase("history.left_out", {{"file", file.string()}}).c_str());
    writeFile(request.page, historyPage(history));
    sayResult(phrase("history.written", {{"file", request.page.string()}}), request.page);
}

} // namespace meltpool
