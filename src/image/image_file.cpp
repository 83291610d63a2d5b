// SPDX-License-Identifier: MIT
#include "image/image_file.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "image/image_io.h"

namespace edgecase {

void* find_image_function(const char* symbol, std::string& error) {
  std::error_code code;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", code);
  const auto path = program.parent_path() / kImageLibrary;
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  // An installed program, and one linked with installed libraries, find the library by their run
  // path. If it lies beside the program and cannot be opened, that is an error, never ignored.
  if (library == nullptr && !std::filesystem::exists(path, code))
    library = dlopen(kImageLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    error = fmt::format("cannot open the image library {}: {}; install libopenimageio2.4",
                        path.string(), dlerror());
    return nullptr;
  }
  void* function = dlsym(library, symbol);
  if (function == nullptr) error = fmt::format("{} lacks {}", path.string(), symbol);
  return function;
}

namespace {

ImageFile refused(std::string error) {
  ImageFile result;
  result.error = std::move(error);
  return result;
}

// Files start with the top row.
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
  // A partly written picture is useless.
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) std::filesystem::remove(path, ignored);
  return fmt::format("cannot write {}: {}", path.string(), error);
}

}  // namespace edgecase
