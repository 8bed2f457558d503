#include "app/session/lesson_sound.hpp"

namespace meltpool {

ParameterList describe(SoundParameters& p, std::string_view device) {
    return {
        {"volume", "Volume", "", &p.volume, 0, 1, device.empty() ? "Loudness of the weld. 0 is silence." : device},
        {"captions", "Captions", "", &p.captions, 0, 1, "Shows the sounds in words at the picture's lower edge."},
    };
}

} // namespace meltpool
