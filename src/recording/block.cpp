// SPDX-License-Identifier: MIT
#include "recording/block.h"

#include <stdexcept>

#include "recording/bytes.h"
#include "recording/line_columns.h"
#include "recording/number_coding.h"

namespace edgecase::recording {

std::string pack_block(const std::vector<std::string>& lines) {
  const LineColumns parts = take_apart(lines);
  std::string bytes;
  write_deflated(parts.text, bytes);
  write_size(parts.columns.size(), bytes);
  for (const std::vector<double>& column : parts.columns) write_column(column, bytes);
  return bytes;
}

std::vector<std::string> unpack_block(std::string_view bytes) {
  LineColumns parts;
  parts.text = read_deflated(bytes);
  const std::uint64_t columns = read_size(bytes);
  for (std::uint64_t i = 0; i < columns; ++i) parts.columns.push_back(read_column(bytes));
  if (!bytes.empty()) throw std::runtime_error("there is something behind the last column");
  return put_together(parts);
}

}  // namespace edgecase::recording
