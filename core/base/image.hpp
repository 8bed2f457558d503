// An 8-bit RGB picture in memory and as PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace meltpool {

/// Rows from top to bottom, three bytes (sRGB) a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// The bytes of the picture's PNG file. Throws RuntimeFault if memory does not suffice.
std::string pngBytes(const Image& image);

/// Writes the whole picture or nothing; throws as writeFile().
void writePng(const std::filesystem::path& file, const Image& image);

/// Reads a PNG picture. Throws InputError if the file is missing or no picture.
Image readPng(const std::filesystem::path& file);

/// The difference of two pictures of equal size.
struct ImageDifference {
    double mean = 0;      ///< mean absolute difference of all channels, 0..255
    double farPixels = 0; ///< share of pixels with a channel that differs by more than `threshold`
    int largest = 0;      ///< largest difference of a channel
};

/// Compares two pictures. Throws InputError if their sizes differ.
ImageDifference compareImages(const Image& a, const Image& b, int threshold);

} // namespace meltpool
