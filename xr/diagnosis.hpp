// The headset part of `meltpool doctor`: names the parts found, the missing ones and the remedy.
#pragma once

#include <string>
#include <vector>

namespace meltpool::xr {

struct Fact {
    std::string name;  ///< "OpenXR runtime"
    std::string value; ///< "Monado 25.0.0"
    bool good = true;  ///< false: this prevents the use of the headset
};

struct Diagnosis {
    bool usable = false; ///< a headset could be used now
    std::vector<Fact> facts;
    std::string advice; ///< remedy, as a sentence for the person; empty if no part is missing
};

/// Examines loader, runtime, headset, extensions, formats, refresh rate and controllers. With `session` an OpenGL
/// context must be current: a session is opened for up to 3 seconds to see formats and controllers. Throws nothing.
Diagnosis diagnose(bool session);

} // namespace meltpool::xr
