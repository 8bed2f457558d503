// `meltpool validate`: how far the metal is from exact solutions and experiments.
#include "app/commands.hpp"
#include "app/program_info.hpp"
#include "core/base/resources.hpp"
#include "core/base/text.hpp"
#include "core/gl/context.hpp"
#include "core/metal/validation.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace meltpool {

namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no number that is not finite.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numberJson(const ValidationNumber& number) {
    Json json{{"name", number.name}, {"origin", number.origin}, {"ours", finite(number.ours)}};
    if (number.origin != "ours") json["reference"] = number.reference;
    if (number.origin == "exact" || number.origin == "measured") {
        json["error_percent"] = finite(number.errorPercent);
        json["tolerance_percent"] = number.tolerancePercent;
    }
    if (!number.moment.empty()) json["at"] = number.moment;
    json["passed"] = number.passed;
    return json;
}

Json resultJson(const ValidationResult& result) {
    Json json{{"name", result.name},
              {"kind", result.kind},
              {"file", result.file.string()},
              {"spacing_mm", result.spacing * 1e3},
              {"particles", result.particles},
              {"steps", result.steps},
              {"wall_seconds", result.wallSeconds},
              {"passed", result.passed()}};
    for (const ValidationNumber& number : result.numbers)
        json["numbers"].push_back(numberJson(number));
    return json;
}

} // namespace

bool runValidation(const ValidationRequest& request) {
    const auto files = request.cases.empty() ? validationCaseFiles(resourceFolder() / "validation") : request.cases;
    // Every file is read before the first is run: a fault in the last must not cost the time of the others.
    std::vector<ValidationCase> cases;
    for (const auto& file : files)
        cases.push_back(readValidationCase(file));
    if (!request.json.empty()) writeTextFileAtomically(request.json, "");

    const gl::HeadlessContext context(false);
    gl::ShaderLibrary shaders(resourceFolder() / "shaders");
    Json json{{"renderer", context.info().renderer}, {"version", programVersion()}, {"commit", programCommit()}};
    json["cases"] = Json::array();
    std::vector<std::string> failed;
    std::fputs(validationHeads().c_str(), stdout);
    for (const ValidationCase& one : cases) {
        const ValidationResult result = runValidationCase(one, shaders);
        std::fputs(validationText(result).c_str(), stdout);
        std::fflush(stdout);
        json["cases"].push_back(resultJson(result));
        if (!result.passed()) failed.push_back(result.name);
    }
    std::printf("%zu of %zu cases passed\n", cases.size() - failed.size(), cases.size());
    for (const std::string& name : failed)
        std::printf("failed: %s\n", name.c_str());
    json["passed"] = failed.empty();
    if (!request.json.empty()) writeTextFileAtomically(request.json, json.dump(2) + "\n");
    return failed.empty();
}

} // namespace meltpool
