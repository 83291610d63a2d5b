// SPDX-License-Identifier: MIT
//
// The only user of OpenImageIO, for reading and writing files. Its comparisons are not used.
#include "image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace {

using edgecase::ImageHeader;

int fail(const std::string& reason, char* error, std::size_t error_size) {
  const std::size_t length = std::min(reason.size(), error_size - 1);
  std::copy_n(reason.begin(), length, error);
  error[length] = '\0';
  return 1;
}

int write_bytes(const char* path, const std::vector<unsigned char>& bytes, char* error,
                std::size_t error_size) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  return out ? 0 : fail(std::strerror(errno), error, error_size);
}

// 0 if a texture cannot hold components of this type exactly.
int bits_of(OIIO::TypeDesc type) {
  if (type == OIIO::TypeDesc::UINT8) return 8;
  if (type == OIIO::TypeDesc::UINT16) return 16;
  if (type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT) return 32;
  return 0;
}

// Expands grey, grey with alpha, colour, or colour with alpha to four components.
void spread(const std::vector<float>& values, std::size_t channels, float opaque, float* rgba) {
  const bool grey = channels < 3;
  for (std::size_t at = 0; at < values.size(); at += channels, rgba += 4) {
    for (std::size_t c = 0; c < 3; ++c) rgba[c] = values[at + (grey ? 0 : c)];
    rgba[3] = channels % 2 == 0 ? values[at + channels - 1] : opaque;
  }
}

// Reads the file's own numbers; OpenImageIO would map those of 8 and 16 bits to 0..1 and round.
template <class Component>
bool read_as(OIIO::ImageInput& input, OIIO::TypeDesc type, int channels,
             std::vector<float>& values) {
  std::vector<Component> raw(values.size());
  if (!input.read_image(0, 0, 0, channels, type, raw.data())) return false;
  std::copy(raw.begin(), raw.end(), values.begin());
  return true;
}

bool read_values(OIIO::ImageInput& input, int bits, int channels, std::vector<float>& values) {
  if (bits == 8) return read_as<std::uint8_t>(input, OIIO::TypeDesc::UINT8, channels, values);
  if (bits == 16) return read_as<std::uint16_t>(input, OIIO::TypeDesc::UINT16, channels, values);
  return input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data());
}

}  // namespace

extern "C" int edgecase_write_image(const char* path, int width, int height,
                                    const std::uint8_t* rgba, char* error, std::size_t error_size) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
  if (!output) return fail(OIIO::geterror(), error, error_size);
  OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:ColorSpace", "sRGB");
  // This goes through memory because the library does not notice files that cannot be written.
  OIIO::Filesystem::IOVecOutput bytes;
  if (!output->set_ioproxy(&bytes) || !output->open(path, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, rgba) || !output->close())
    return fail(output->geterror(), error, error_size);
  return write_bytes(path, bytes.buffer(), error, error_size);
}

extern "C" int edgecase_read_image(const char* path, ImageHeader* header, float* rgba, char* error,
                                   std::size_t error_size) {
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wanted);
  if (!input) return fail(OIIO::geterror(), error, error_size);
  const OIIO::ImageSpec& spec = input->spec();
  const ImageHeader found{spec.width, spec.height, bits_of(spec.format)};
  if (found.bits == 0)
    return fail(std::string("its components are of type ") + spec.format.c_str(), error,
                error_size);
  if (spec.nchannels < 1 || spec.nchannels > 4 || spec.depth > 1)
    return fail("it has " + std::to_string(spec.nchannels) + " channels", error, error_size);
  if (rgba == nullptr) {
    *header = found;
    return 0;
  }
  if (found.width != header->width || found.height != header->height || found.bits != header->bits)
    return fail("it changed while it was read", error, error_size);
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> values(channels * static_cast<std::size_t>(spec.width) *
                            static_cast<std::size_t>(spec.height));
  if (!read_values(*input, found.bits, spec.nchannels, values))
    return fail(input->geterror(), error, error_size);
  const float opaque = found.bits == 8 ? 255.0F : found.bits == 16 ? 65535.0F : 1.0F;
  spread(values, channels, opaque, rgba);
  return 0;
}
