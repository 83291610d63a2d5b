// SPDX-License-Identifier: MIT
#include "results/deflate.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace edgecase {

std::vector<std::uint8_t> deflated(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::vector<std::uint8_t> bytes(size);
  if (compress(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()),
               static_cast<uLong>(text.size())) != Z_OK)
    throw std::runtime_error("a long value cannot be deflated");
  bytes.resize(size);
  return bytes;
}

// The stream ends in a checksum, so that damage is noticed.
std::string inflated(const std::vector<std::uint8_t>& bytes, std::size_t most) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::runtime_error("there is no memory to inflate");
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::vector<char> buffer(1 << 16);
  int status = Z_OK;
  while (status == Z_OK && text.size() <= most) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    status = inflate(&stream, Z_NO_FLUSH);
    text.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (text.size() > most)
    throw std::runtime_error(fmt::format("a deflated value is longer than {} bytes", most));
  if (status != Z_STREAM_END) throw std::runtime_error("a deflated value is damaged");
  return text;
}

}  // namespace edgecase
