// SPDX-License-Identifier: MIT
//
// Recordings. Checksums would refuse nearly every input at once, so the bytes are taken for a whole
// file, for the index of one whose checksums are right, and for a block.
#include "recording/recording.h"

#include <fmt/format.h>

#include <stdexcept>
#include <variant>

#include "recording/block.h"
#include "recording/bytes.h"
#include "tests/fuzz/byte_file.h"

namespace {

using namespace edgecase;

void open_whole(std::string_view bytes) {
  const ByteFile file(bytes);
  const auto opened = Recording::open(file.path());
  if (const auto* fault = std::get_if<std::string>(&opened))
    promise(!fault->empty(), "a refusal has a reason");
  Recording::open_head(file.path());
}

void open_with_index(std::string_view text) {
  std::string index;
  recording::write_deflated(text, index);
  open_whole(fmt::format("edgecase-recording {}\n{{}}\n{}{:016x} {:08x}\n", kRecordingVersion,
                         index, index.size(), recording::checksum(index)));
}

void unpack(std::string_view bytes) {
  std::vector<std::string> lines;
  try {
    lines = recording::unpack_block(bytes, kLongestBlock);
  } catch (const std::runtime_error&) {
    return;
  }
  promise(recording::unpack_block(recording::pack_block(lines), kLongestBlock) == lines,
          "lines that are read come back");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes = text_of(data + 1, size - 1);
  if (data[0] == 'r') open_whole(bytes);
  if (data[0] == 'i') open_with_index(bytes);
  if (data[0] == 'b') unpack(bytes);
  return 0;
}
