#include "core/render/large_picture.hpp"

#include "core/render/picture_target.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace meltpool {

namespace {

constexpr int kFineSteps =
    1 << 14; ///< steps of light's root, for the way back to displayed values: a hundredth of a step of 255

/// The sRGB curve and its inverse (IEC 61966-2-1) as tables.
struct Curve {
    std::array<float, 256> light;
    std::array<std::uint8_t, kFineSteps + 1> shown;

    Curve() {
        for (size_t i = 0; i < light.size(); ++i) {
            const double s = static_cast<double>(i) / 255;
            light[i] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
        }
        for (size_t i = 0; i < shown.size(); ++i) {
            // Steps are even in the root of light: the curve is steep in the dark.
            const double root = static_cast<double>(i) / kFineSteps, l = root * root;
            const double s = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
            shown[i] = static_cast<std::uint8_t>(std::lround(255 * s));
        }
    }

    std::uint8_t toShown(float l) const {
        return shown[static_cast<size_t>(std::lround(std::sqrt(std::min(l, 1.0f)) * kFineSteps))];
    }
};

/// Averages the light of `finer` x `finer` pixels of the tile, but for its margin, into each pixel of the picture from
/// `left`, `top` on.
void place(const Image& tile, const LargePicture& wish, int left, int top, const Curve& curve, Image& picture) {
    const int finer = wish.finer, margin = wish.margin;
    const int width = std::min(tile.width / finer - 2 * margin, picture.width - left);
    const int height = std::min(tile.height / finer - 2 * margin, picture.height - top);
    const float share = 1.0f / static_cast<float>(finer * finer);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::array<float, 3> sum{};
            const int first = (y + margin) * finer, column = (x + margin) * finer;
            for (int row = first; row < first + finer; ++row) {
                const auto* pixel = &tile.rgb[3 * (size_t(row) * size_t(tile.width) + size_t(column))];
                for (int i = 0; i < finer; ++i)
                    for (float& channel : sum)
                        channel += curve.light[*pixel++];
            }
            auto* to = &picture.rgb[3 * (size_t(top + y) * size_t(picture.width) + size_t(left + x))];
            for (const float channel : sum)
                *to++ = curve.toShown(channel * share);
        }
}

} // namespace

View viewOfPart(const View& whole, glm::ivec2 size, glm::ivec2 corner, glm::ivec2 part) {
    View view = whole;
    for (int axis = 0; axis < 2; ++axis) {
        // Converts the picture's -1..1 to the part's own: enlarged about the part's middle, if that is in -1..1.
        const float larger = static_cast<float>(size[axis]) / static_cast<float>(part[axis]);
        const float middle = static_cast<float>(2 * corner[axis] + part[axis]) / static_cast<float>(size[axis]) - 1;
        for (int column = 0; column < 4; ++column)
            view.eyeToClip[column][axis] =
                larger * (whole.eyeToClip[column][axis] - middle * whole.eyeToClip[column][3]);
    }
    return view;
}

glm::ivec2 fitInto(glm::ivec2 shape, glm::ivec2 most) {
    const glm::dvec2 wanted(glm::max(shape, glm::ivec2(1))), room(most);
    const double scale = std::min(room.x / wanted.x, room.y / wanted.y);
    return glm::max(glm::ivec2(glm::round(wanted * scale)), glm::ivec2(1));
}

Image drawLargePicture(const LargePicture& wish, const View& view,
                       const std::function<void(const View&, const RenderTarget&)>& draw) {
    const glm::ivec2 part = glm::min(wish.tile, wish.size);
    const glm::ivec2 drawn = part + 2 * wish.margin;
    const PictureTarget target(drawn.x * wish.finer, drawn.y * wish.finer, wish.samples);
    Image picture{wish.size.x, wish.size.y, {}};
    picture.rgb.resize(3 * size_t(wish.size.x) * size_t(wish.size.y));
    const Curve curve;
    for (int top = 0; top < wish.size.y; top += part.y)
        for (int left = 0; left < wish.size.x; left += part.x) {
            // Rows of the picture begin at its top, the view's at its bottom.
            const glm::ivec2 corner(left, wish.size.y - top - part.y);
            draw(viewOfPart(view, wish.size, corner - wish.margin, drawn), target.target());
            place(target.read(), wish, left, top, curve, picture);
        }
    return picture;
}

} // namespace meltpool
