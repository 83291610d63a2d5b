// SPDX-License-Identifier: MIT
#include "casefile/text_file.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace edgecase {

TextFile read_text_file(const std::filesystem::path& file, std::size_t limit) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    return {{}, "there is no such file", "check the path's spelling"};
  if (!std::filesystem::is_regular_file(status))
    return {{}, "this is no regular file", "name a regular file"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {{}, "the file cannot be opened", "check its permissions"};
  // One byte more than allowed tells a file that is too large, even while it grows.
  std::string text(limit + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) return {{}, "the file cannot be read", "check the disk and its permissions"};
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > limit)
    return {{}, fmt::format("larger than {} bytes", limit), "make the file smaller"};
  return {std::move(text), "", ""};
}

}  // namespace edgecase
