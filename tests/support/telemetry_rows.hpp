// Reads the rows that a running window adds to its telemetry, one by one: the newest row alone is too little for a
// test, which may pause while a window continues.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace meltpool::test {

class TelemetryRows {
  public:
    explicit TelemetryRows(std::filesystem::path file) : file_(std::move(file)) {}

    /// Begin of the next row: the bytes of all whole rows, 0 without any.
    std::streamoff end() const { return newestLine().second; }
    /// Returns the last row written; null without any.
    nlohmann::json newest() const {
        const auto [begin, end] = newestLine();
        std::streamoff at = begin;
        return begin == end ? nlohmann::json() : read(at);
    }
    /// Begin of the newest row, for reading from it on; 0 without any.
    std::streamoff newestBegin() const { return newestLine().first; }
    /// Reads the row that begins at `at`, and moves `at` behind it; null while that row is missing or incomplete.
    nlohmann::json read(std::streamoff& at) const {
        std::ifstream in(file_, std::ios::binary);
        in.seekg(at);
        std::string line;
        if (!in || !std::getline(in, line) || in.eof()) return nullptr;
        at += static_cast<std::streamoff>(line.size()) + 1;
        return nlohmann::json::parse(line);
    }

  private:
    /// Finds begin and end of the newest whole row in the file.
    std::pair<std::streamoff, std::streamoff> newestLine() const {
        std::ifstream in(file_, std::ios::binary | std::ios::ate);
        if (!in) return {0, 0};
        const auto size = static_cast<std::streamoff>(in.tellg());
        constexpr std::streamoff kTail = 128 * 1024; // more than a row and the begin of the next one
        const std::streamoff from = std::max<std::streamoff>(0, size - kTail);
        in.seekg(from);
        std::ostringstream text;
        text << in.rdbuf();
        const std::string tail = text.str();
        const size_t end = tail.rfind('\n');
        if (end == std::string::npos) return {0, 0};
        const size_t before = end == 0 ? std::string::npos : tail.rfind('\n', end - 1);
        const size_t begin = before == std::string::npos ? 0 : before + 1;
        return {from + static_cast<std::streamoff>(begin), from + static_cast<std::streamoff>(end) + 1};
    }

    std::filesystem::path file_;
};

} // namespace meltpool::test
