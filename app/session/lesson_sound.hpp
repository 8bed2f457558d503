// Sound and captions of the lesson, with one set of settings for all lessons.
#pragma once

#include "core/base/parameter.hpp"
#include "core/training/feedback/sound/sound_steps.hpp"

namespace meltpool {

struct SoundParameters {
    float volume = 0.6f;   ///< 0 silent .. 1
    bool captions = false; ///< true: captions describe the sounds
};

/// Parameters of menus and settings. `device`: a sentence about the sound device for the volume's help, which must
/// outlive the list; may be empty.
ParameterList describe(SoundParameters& parameters, std::string_view device = {});

struct LessonSound {
    SoundParameters parameters;
    SoundSteps soundSteps;

    /// Caption of the current sound; empty if captions are off or nothing sounds.
    std::string_view caption() const { return parameters.captions ? soundSteps.caption() : std::string_view(); }
};

} // namespace meltpool
