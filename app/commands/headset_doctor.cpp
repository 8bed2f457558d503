#include "app/commands/headset_doctor.hpp"

#include "core/base/error.hpp"
#include "core/gl/context.hpp"
#include "xr/diagnosis.hpp"

#include <memory>

namespace meltpool {

namespace {

void lookForHeadset(std::vector<Finding>& findings) {
    std::unique_ptr<gl::HeadlessContext> context;
    try {
        context = std::make_unique<gl::HeadlessContext>(false);
    } catch (const std::exception&) {
        // inspectDriver() has reported it already.
    }
    const xr::Diagnosis diagnosis = xr::diagnose(context != nullptr);
    for (const xr::Fact& fact : diagnosis.facts)
        findings.push_back({fact.name, fact.good ? Finding::State::good : Finding::State::note, fact.value, ""});
    if (!diagnosis.advice.empty()) findings.back().remedy = diagnosis.advice;
}

} // namespace

void inspectHeadset(std::vector<Finding>& findings) {
    try {
        lookForHeadset(findings);
    } catch (const InputError&) { // the reasons' words are missing; inspectFiles() has reported it already
        findings.push_back({"headset", Finding::State::note, "not looked for without the program's files", ""});
    }
}

} // namespace meltpool
