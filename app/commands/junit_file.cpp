#include "app/commands/junit_file.hpp"

#include "core/base/text.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <sstream>

namespace meltpool {

namespace {

std::string joined(const std::vector<std::string>& sentences, const char* between) {
    std::string all;
    for (const std::string& sentence : sentences)
        all += (all.empty() ? "" : between) + printable(sentence, 1000);
    return all;
}

} // namespace

bool CheckOutcome::passed() const {
    return error.empty() && std::all_of(values.begin(), values.end(), [](const auto& each) { return each.passed; });
}

std::vector<std::string> CheckOutcome::faults() const {
    std::vector<std::string> sentences;
    if (!error.empty()) sentences.push_back(error);
    for (const CheckedValue& each : values)
        if (!each.passed) sentences.push_back(each.key + " is " + each.found + "; expected " + each.expected);
    return sentences;
}

void writeJunitFile(const std::filesystem::path& file, const std::vector<CheckOutcome>& outcomes) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
    suite.append_attribute("name") = "meltpool check";
    suite.append_attribute("tests") = outcomes.size();
    const auto failed = [](const CheckOutcome& each) { return each.error.empty() && !each.passed(); };
    const auto broken = [](const CheckOutcome& each) { return !each.error.empty(); };
    suite.append_attribute("failures") = std::count_if(outcomes.begin(), outcomes.end(), failed);
    suite.append_attribute("errors") = std::count_if(outcomes.begin(), outcomes.end(), broken);
    for (const CheckOutcome& each : outcomes) {
        pugi::xml_node one = suite.append_child("testcase");
        one.append_attribute("classname") = each.file.parent_path().filename().string().c_str();
        one.append_attribute("name") = each.name.c_str();
        one.append_attribute("time") = each.wallSeconds;
        if (!each.passed())
            one.append_child(broken(each) ? "error" : "failure").append_attribute("message") =
                joined(each.faults(), "; ").c_str();
        if (!each.warnings.empty()) one.append_child("system-err").text() = joined(each.warnings, "\n").c_str();
    }
    std::ostringstream text;
    document.save(text, "  ");
    writeTextFileAtomically(file, text.str());
}

} // namespace meltpool
