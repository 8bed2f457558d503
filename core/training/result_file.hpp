// result.json: the figures of a run in a form that programs and people read.
#pragma once

#include "core/render/section.hpp"
#include "core/training/trainer.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meltpool {

/// What a cut across a weld shows, m.
struct SectionFigures {
    double at = 0;                           ///< along the seam
    SectionZone fusion;                      ///< peak temperature reached the solidus
    std::optional<SectionZone> heatAffected; ///< reached kSteelTransformation, in metals that melt above it
};

/// Temperature above which steel changes its grain, K (A1, 723 °C).
inline constexpr double kSteelTransformation = 996.15;

/// What a result says beside the metal's figures.
struct ResultContext {
    std::string version;
    std::string commit;
    std::string renderer;
    double wallSeconds = 0;
    std::optional<SectionFigures> section = {}; ///< of the last picture that cut the metal
    std::string error = {};                     ///< why the run ended early; empty when it did not
};

/// Writes the figures of a run together with every parameter it had. Throws InputError when the file cannot be written.
void writeResult(const std::filesystem::path& file, Lesson& lesson, const LessonResult& result,
                 const ResultContext& context);

} // namespace meltpool
