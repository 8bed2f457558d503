#include "app/desktop/window_place.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>

namespace meltpool {

namespace {

bool known(const ScreenArea& area) {
    return area.size.x > 0 && area.size.y > 0;
}

glm::ivec2 scaled(glm::ivec2 size, float scale) {
    return {static_cast<int>(std::lround(static_cast<float>(size.x) * scale)),
            static_cast<int>(std::lround(static_cast<float>(size.y) * scale))};
}

} // namespace

glm::ivec2 fittingSize(glm::ivec2 wanted, float scale, const ScreenArea& workArea, const WindowFrame& frame) {
    const glm::ivec2 size = scaled(wanted, scale);
    if (!known(workArea)) return size;
    return glm::max(glm::min(size, workArea.size - frame.topLeft - frame.bottomRight), glm::ivec2(1));
}

glm::ivec2 leastSize(float scale, glm::ivec2 fitting) {
    return glm::min(scaled({640, 480}, scale), fitting);
}

std::optional<glm::ivec2> placeInside(const ScreenArea& window, const WindowFrame& frame, const ScreenArea& workArea) {
    if (!known(workArea)) return std::nullopt;
    const glm::ivec2 low = window.corner - frame.topLeft;
    const glm::ivec2 size = window.size + frame.topLeft + frame.bottomRight;
    const glm::ivec2 end = workArea.corner + workArea.size;
    if (glm::all(glm::greaterThanEqual(low, workArea.corner)) && glm::all(glm::lessThanEqual(low + size, end)))
        return std::nullopt;
    return workArea.corner + glm::max((workArea.size - size) / 2, glm::ivec2(0)) + frame.topLeft;
}

size_t screenOf(const ScreenArea& window, std::span<const ScreenArea> screens) {
    size_t best = 0;
    long long most = 0;
    for (size_t i = 0; i < screens.size(); ++i) {
        const glm::ivec2 low = glm::max(window.corner, screens[i].corner);
        const glm::ivec2 high = glm::min(window.corner + window.size, screens[i].corner + screens[i].size);
        const glm::ivec2 both = glm::max(high - low, glm::ivec2(0));
        const long long shown = static_cast<long long>(both.x) * both.y;
        if (shown <= most) continue;
        most = shown;
        best = i;
    }
    return best;
}

} // namespace meltpool
