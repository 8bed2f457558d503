#include "core/render/look/kept_picture.hpp"

#include "core/base/hash.hpp"
#include "core/base/output_file.hpp"

#include <exception>
#include <fstream>
#include <string>

namespace meltpool {

namespace {

/// Header of the picture's file.
struct Head {
    std::uint64_t key;
    std::uint64_t picture; ///< hash of its bytes
};

} // namespace

std::optional<std::vector<std::byte>> keptPicture(const std::filesystem::path& file, std::uint64_t key, size_t bytes) {
    std::error_code unreadable;
    if (std::filesystem::file_size(file, unreadable) != sizeof(Head) + bytes || unreadable) return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    Head head{};
    std::vector<std::byte> picture(bytes);
    in.read(reinterpret_cast<char*>(&head), sizeof(head));
    in.read(reinterpret_cast<char*>(picture.data()), static_cast<std::streamsize>(bytes));
    if (!in || head.key != key || head.picture != hashOfBytes(picture)) return std::nullopt;
    return picture;
}

void keepPicture(const std::filesystem::path& file, std::uint64_t key, std::span<const std::byte> picture) {
    const Head head{key, hashOfBytes(picture)};
    std::string whole(reinterpret_cast<const char*>(&head), sizeof(head));
    whole.append(reinterpret_cast<const char*>(picture.data()), picture.size());
    try {
        std::filesystem::create_directories(file.parent_path());
        writeFile(file, whole);
    } catch (const std::exception&) {
        // Handles a home without room or permission: see the header.
    }
}

} // namespace meltpool
