// `meltpool report`: the results of a run as one page for people.
#include "app/commands/commands.hpp"
#include "app/report/report_page.hpp"
#include "core/base/output_file.hpp"

#include <cstdio>

namespace meltpool {

void writeReport(const std::filesystem::path& folder, const std::filesystem::path& file) {
    const std::filesystem::path page = file.empty() ? folder / "report.html" : file;
    writeFile(page, reportPage(readRunResults(folder)));
    std::printf("The report is %s\n", page.string().c_str());
}

} // namespace meltpool
