// SPDX-License-Identifier: MIT
//
// Reads a whole text file of bounded size. Only regular files: a pipe or a device could keep a run
// waiting for ever.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace edgecase {

struct TextFile {
  std::optional<std::string> text;
  std::string message;  // why there is none
  std::string remedy;
};

// Never throws. A file of more than `limit` bytes is refused.
TextFile read_text_file(const std::filesystem::path& file, std::size_t limit);

}  // namespace edgecase
