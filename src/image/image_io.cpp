// SPDX-License-Identifier: MIT
//
// The only user of OpenImageIO: files in and out, nothing else. Comparing is never left to it.
#include "image/image_io.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <string>

namespace {

int fail(const std::string& reason, char* error, std::size_t error_size) {
  const std::size_t length = std::min(reason.size(), error_size - 1);
  std::copy_n(reason.begin(), length, error);
  error[length] = '\0';
  return 1;
}

}  // namespace

extern "C" int edgecase_write_image(const char* path, int width, int height,
                                    const std::uint8_t* rgba, char* error, std::size_t error_size) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
  if (!output) return fail(OIIO::geterror(), error, error_size);
  OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:ColorSpace", "sRGB");
  if (!output->open(path, spec) || !output->write_image(OIIO::TypeDesc::UINT8, rgba) ||
      !output->close())
    return fail(output->geterror(), error, error_size);
  return 0;
}
