// Random damage to texts by their structure: lines, keys, numbers, strings and brackets.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace meltpool::test {

/// Makes inputs from a corpus. One corpus, seed and index give one text on every machine.
class Mutator {
  public:
    /// `corpus` has at least one text; words of all of them are exchanged.
    explicit Mutator(std::vector<std::string> corpus);

    /// Returns input number `index`: a text of the corpus with one to eight wounds.
    std::string input(std::uint64_t index);

  private:
    size_t below(size_t limit) { return limit == 0 ? 0 : static_cast<size_t>(random_() % limit); }
    const std::string& anyText() { return corpus_[below(corpus_.size())]; }
    std::string anyWord();
    /// Returns the begin and the end of a random word of `text`.
    std::pair<size_t, size_t> wordIn(const std::string& text);
    std::pair<size_t, size_t> lineIn(const std::string& text);

    void wound(std::string& text);
    void woundBytes(std::string& text);
    void woundLines(std::string& text);
    void woundWords(std::string& text);
    void woundStructure(std::string& text);

    std::vector<std::string> corpus_;
    std::vector<std::string> words_;
    std::mt19937_64 random_;
};

} // namespace meltpool::test
