// SPDX-License-Identifier: MIT
#include "image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "image/image_io.h"
#include "image/image_library.h"

namespace edgecase {
namespace {

ImageFile refused(std::string error) {
  ImageFile result;
  result.error = std::move(error);
  return result;
}

// Files have their top row first.
void flip(ImageFile& image) {
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  const auto rows = static_cast<std::size_t>(image.height);
  for (std::size_t y = 0; y < rows / 2; ++y) {
    const auto below = image.rgba.begin() + static_cast<std::ptrdiff_t>(y * row);
    const auto above = image.rgba.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row);
    std::swap_ranges(below, below + static_cast<std::ptrdiff_t>(row), above);
  }
}

}  // namespace

ImageFile read_image(const std::filesystem::path& path, int largest) {
  static std::string load_error;
  static auto* const read =
      reinterpret_cast<ReadImageFunction*>(find_image_function(kReadImageSymbol, load_error));
  if (read == nullptr) return refused(load_error);
  char error[256] = "";
  ImageHeader header;
  if (read(path.c_str(), &header, nullptr, error, sizeof error) != 0) return refused(error);
  if (std::max(header.width, header.height) > largest || header.width < 1 || header.height < 1)
    return refused(fmt::format("it has {} x {} pixels", header.width, header.height));
  ImageFile image{header.width, header.height, header.bits, {}, ""};
  image.rgba.resize(4 * static_cast<std::size_t>(header.width) *
                    static_cast<std::size_t>(header.height));
  if (read(path.c_str(), &header, image.rgba.data(), error, sizeof error) != 0)
    return refused(error);
  flip(image);
  return image;
}

}  // namespace edgecase
