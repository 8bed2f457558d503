#include "core/base/image.hpp"

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/stb_headers.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace meltpool {

std::string pngBytes(const Image& image) {
    // Encodes into memory: stb reports no errors for files that it writes itself.
    std::string bytes;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
    };
    if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.rgb.data(), image.width * 3) == 0)
        throw RuntimeFault("there is not enough memory to make a picture's file");
    return bytes;
}

void writePng(const std::filesystem::path& file, const Image& image) {
    writeFile(file, pngBytes(image));
}

Image readPng(const std::filesystem::path& file) {
    Image image;
    int channels = 0;
    std::uint8_t* pixels = stbi_load(file.string().c_str(), &image.width, &image.height, &channels, 3);
    if (pixels == nullptr) throw InputError(file, 0, "cannot be read; expected a PNG picture");
    image.rgb.assign(pixels, pixels + static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3);
    stbi_image_free(pixels);
    return image;
}

ImageDifference compareImages(const Image& a, const Image& b, int threshold) {
    if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size())
        throw InputError("pictures of " + std::to_string(a.width) + "x" + std::to_string(a.height) + " and " +
                         std::to_string(b.width) + "x" + std::to_string(b.height) +
                         " cannot be compared; expected the same size");
    ImageDifference difference;
    size_t farPixels = 0;
    double sum = 0;
    for (size_t pixel = 0; pixel + 2 < a.rgb.size(); pixel += 3) {
        int worst = 0;
        for (size_t channel = pixel; channel < pixel + 3; ++channel) {
            const int off = std::abs(int(a.rgb[channel]) - int(b.rgb[channel]));
            sum += off;
            worst = std::max(worst, off);
        }
        difference.largest = std::max(difference.largest, worst);
        farPixels += worst > threshold ? 1u : 0u;
    }
    const double values = std::max<double>(1.0, double(a.rgb.size()));
    difference.mean = sum / values;
    difference.farPixels = double(farPixels) / (values / 3);
    return difference;
}

} // namespace meltpool
