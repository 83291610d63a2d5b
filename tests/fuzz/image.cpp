// SPDX-License-Identifier: MIT
//
// Image files of every kind that OpenImageIO reads. Only our side of it is instrumented.
#include "image/image_file.h"
#include "tests/fuzz/byte_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace edgecase;
  constexpr int kLargest = 64;  // pixels along a side
  const ByteFile file(text_of(data, size));
  const ImageFile image = read_image(file.path(), kLargest);
  if (!image.error.empty()) return 0;
  promise(
      image.width > 0 && image.width <= kLargest && image.height > 0 && image.height <= kLargest,
      "larger images are refused");
  promise(image.rgba.size() ==
              4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
          "four numbers a pixel");
  return 0;
}
