// What a person hears of the lesson, and reads of it as captions: the settings of both, the same in every lesson.
#pragma once

#include "core/base/parameter.hpp"
#include "core/training/feedback/sound/ear.hpp"

namespace meltpool {

struct SoundParameters {
    float volume = 0.6f;   ///< 0 silent .. 1
    bool captions = false; ///< what is heard is told in words
};

/// `device`: a sentence about the sound device for the volume's help, which must outlive the list; may be empty.
ParameterList describe(SoundParameters& parameters, std::string_view device = {});

struct Hearing {
    SoundParameters parameters;
    Ear ear;

    /// Empty where captions are off or nothing sounds.
    std::string_view caption() const { return parameters.captions ? ear.caption() : std::string_view(); }
};

} // namespace meltpool
