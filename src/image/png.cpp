// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "image/image_io.h"
#include "image/image_library.h"

namespace edgecase {
namespace {

std::vector<std::uint8_t> flipped_and_enlarged(const ImageView& image, int scale) {
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const auto factor = static_cast<std::size_t>(scale);
  std::vector<std::uint8_t> result;
  result.reserve(4 * width * height * factor * factor);
  for (std::size_t y = 0; y < height * factor; ++y) {
    const std::size_t row = height - 1 - y / factor;
    for (std::size_t x = 0; x < width * factor; ++x) {
      const auto pixel = image.rgba.subspan(4 * (row * width + x / factor), 4);
      result.insert(result.end(), pixel.begin(), pixel.end());
    }
  }
  return result;
}

}  // namespace

std::string write_png(const std::filesystem::path& path, const ImageView& image, int scale) {
  static std::string load_error;
  static auto* const write =
      reinterpret_cast<WriteImageFunction*>(find_image_function(kWriteImageSymbol, load_error));
  if (write == nullptr) return load_error;
  const auto pixels = flipped_and_enlarged(image, scale);
  char error[256] = "";
  const int width = image.width * scale;
  const int height = image.height * scale;
  if (write(path.c_str(), width, height, pixels.data(), error, sizeof error) == 0) return "";
  // Half a picture is none.
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) std::filesystem::remove(path, ignored);
  return fmt::format("cannot write {}: {}", path.string(), error);
}

}  // namespace edgecase
