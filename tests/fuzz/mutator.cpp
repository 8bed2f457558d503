#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace meltpool::test {

namespace {

/// Values at which readers have failed: ends of ranges and types, non-numbers, invalid text.
constexpr std::array<std::string_view, 50> kValues{"0",
                                                   "-0",
                                                   "1",
                                                   "-1",
                                                   "0.5",
                                                   "1e300",
                                                   "-1e300",
                                                   "1e-300",
                                                   "1e999",
                                                   "nan",
                                                   "-nan",
                                                   "inf",
                                                   "-inf",
                                                   "2147483647",
                                                   "2147483648",
                                                   "-2147483649",
                                                   "9223372036854775807",
                                                   "9223372036854775808",
                                                   "18446744073709551616",
                                                   "0x7fffffff",
                                                   "0b1",
                                                   "0o7",
                                                   "1_000",
                                                   "1.",
                                                   ".5",
                                                   "+1",
                                                   "--1",
                                                   "1979-05-27",
                                                   "07:32:00",
                                                   "true",
                                                   "false",
                                                   "\"\"",
                                                   "''",
                                                   "\"\\u0000\"",
                                                   "\"\\u001b[31m\"",
                                                   "\"\\uD800\"",
                                                   "[]",
                                                   "[[]]",
                                                   "{}",
                                                   "[1, 2, 3]",
                                                   "{ value = 1, source = \"x\" }",
                                                   "\"x.toml\"",
                                                   "\"../../../../etc/passwd\"",
                                                   "\"/dev/null\"",
                                                   "1,5",
                                                   "1.234,5",
                                                   "1764244800000",
                                                   "\"a \"\"b\"\"\nc\"",
                                                   "sep=;\n",
                                                   "\xFF\xFE"};

constexpr char kByteText[] = "0123456789.,;-+eE#=\n\r\t \"'[]{}_\\naixA\0\x01\x1b\x7f\xff\xc3\xed\xa0";
constexpr std::string_view kBytes(kByteText, sizeof(kByteText) - 1); // one of the bytes is 0

bool isWordByte(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' ||
           c == '+' || c == '.';
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    for (size_t at = 0; at < text.size();) {
        size_t end = at;
        while (end < text.size() && isWordByte(text[end]))
            ++end;
        if (end > at) words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

} // namespace

Mutator::Mutator(std::vector<std::string> corpus) : corpus_(std::move(corpus)) {
    for (const std::string& text : corpus_)
        for (std::string& word : wordsOf(text))
            words_.push_back(std::move(word));
    std::sort(words_.begin(), words_.end());
    words_.erase(std::unique(words_.begin(), words_.end()), words_.end());
    if (words_.empty()) words_.emplace_back("a");
}

std::string Mutator::input(std::uint64_t index) {
    random_.seed(index * 0x9E3779B97F4A7C15u + 1);
    std::string text = anyText();
    for (size_t wounds = 1 + below(8); wounds > 0; --wounds)
        wound(text);
    return text;
}

std::string Mutator::anyWord() {
    if (below(2) == 0) return std::string(kValues[below(kValues.size())]);
    return words_[below(words_.size())];
}

std::pair<size_t, size_t> Mutator::wordIn(const std::string& text) {
    size_t begin = below(text.size());
    while (begin < text.size() && !isWordByte(text[begin]))
        ++begin;
    while (begin > 0 && begin < text.size() && isWordByte(text[begin - 1]))
        --begin;
    size_t end = begin;
    while (end < text.size() && isWordByte(text[end]))
        ++end;
    return {begin, end};
}

std::pair<size_t, size_t> Mutator::lineIn(const std::string& text) {
    const size_t inside = below(text.size());
    const size_t before = inside == 0 ? std::string::npos : text.rfind('\n', inside - 1);
    const size_t begin = before == std::string::npos ? 0 : before + 1;
    const size_t after = text.find('\n', begin);
    return {begin, after == std::string::npos ? text.size() : after + 1};
}

void Mutator::wound(std::string& text) {
    switch (below(8)) {
    case 0:
    case 1:
        return woundBytes(text);
    case 2:
    case 3:
        return woundLines(text);
    case 4:
        return woundStructure(text);
    default:
        return woundWords(text);
    }
}

void Mutator::woundBytes(std::string& text) {
    const size_t at = below(text.size());
    switch (below(5)) {
    case 0:
        text.erase(at, 1 + below(6));
        break;
    case 1:
        text.insert(at, 1, kBytes[below(kBytes.size())]);
        break;
    case 2:
        if (!text.empty()) text[at] = kBytes[below(kBytes.size())];
        break;
    case 3:
        if (!text.empty()) text[at] = static_cast<char>(text[at] ^ static_cast<char>(1u << below(8)));
        break;
    default:
        text.resize(at);
    }
}

void Mutator::woundLines(std::string& text) {
    const auto [begin, end] = lineIn(text);
    const std::string line = text.substr(begin, end - begin);
    const std::string& other = anyText();
    const auto [otherBegin, otherEnd] = lineIn(other);
    switch (below(5)) {
    case 0:
        text.erase(begin, end - begin);
        break;
    case 1:
        text.insert(begin, line);
        break;
    case 2:
        text.erase(begin, end - begin);
        text.insert(lineIn(text).first, line);
        break;
    case 3:
        text.insert(begin, other, otherBegin, otherEnd - otherBegin);
        break;
    default:
        for (size_t i = 1 + below(40); i > 0; --i)
            text.insert(begin, line);
    }
}

void Mutator::woundWords(std::string& text) {
    const auto [begin, end] = wordIn(text);
    switch (below(4)) {
    case 0:
        text.replace(begin, end - begin, words_[below(words_.size())]);
        break;
    case 1:
        text.insert(begin, anyWord() + " ");
        break;
    default:
        text.replace(begin, end - begin, anyWord());
    }
}

void Mutator::woundStructure(std::string& text) {
    const size_t at = below(2) == 0 ? below(text.size()) : lineIn(text).first;
    const size_t times = below(10) == 0 ? 3000 : 1 + below(40);
    std::string part;
    switch (below(8)) {
    case 0:
        part = "[" + anyWord() + "]\n";
        break;
    case 1:
        part = "[[" + anyWord() + "]]\n" + anyWord() + " = " + anyWord() + "\n";
        break;
    case 2:
        part = anyWord() + " = " + anyWord() + "\n";
        break;
    case 3:
        for (size_t i = 0; i < times; ++i)
            part += "a.";
        break;
    case 4:
        part.assign(times, "[{\"'"[below(4)]);
        break;
    case 5:
        part = std::string(times, ',') + std::string(below(3), '\n');
        break;
    case 6:
        part = "\"\"\"" + anyText().substr(0, times) + (below(2) == 0 ? "\"\"\"" : "");
        break;
    default:
        part.assign(times, kBytes[below(kBytes.size())]);
    }
    text.insert(at, part);
}

} // namespace meltpool::test
