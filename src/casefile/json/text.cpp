// SPDX-License-Identifier: MIT
#include "casefile/json/text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>
#include <vector>

namespace edgecase {

namespace {

std::uint8_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<std::uint8_t>(text[i]);
}

bool is_continuation(std::uint8_t byte) {
  return (byte & 0xC0) == 0x80;
}

// Length of the well-formed sequence that starts at `i`, or 0. Unicode 15, table 3-7.
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const std::uint8_t lead = byte_at(text, i);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!is_continuation(byte_at(text, i + k))) return 0;
  const std::uint8_t second = byte_at(text, i + 1);
  if (lead == 0xE0 && second < 0xA0) return 0;  // overlong
  if (lead == 0xED && second > 0x9F) return 0;  // surrogates
  if (lead == 0xF0 && second < 0x90) return 0;  // overlong
  if (lead == 0xF4 && second > 0x8F) return 0;  // above U+10FFFF
  return length;
}

// Edit distance with swaps of neighbours (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * width);
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& cell = table[i * width + j];
      if (i == 0 || j == 0) {
        cell = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      cell = std::min({table[(i - 1) * width + j] + 1, table[i * width + j - 1] + 1,
                       table[(i - 1) * width + j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cell = std::min(cell, table[(i - 2) * width + j - 2] + 1);
    }
  }
  return table.back();
}

}  // namespace

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return !is_continuation(static_cast<std::uint8_t>(c));
  }));
}

std::string clean_line(std::string text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    const bool is_control = byte_at(text, i) < 0x20 || text[i] == 0x7F;
    if (length == 0 || is_control) text[i] = '?';
    i += std::max<std::size_t>(length, 1);
  }
  return text;
}

std::string_view beginning_of(std::string_view text, std::size_t most) {
  std::size_t end = std::min(text.size(), most);
  while (end < text.size() && end > 0 && is_continuation(byte_at(text, end))) --end;
  return text.substr(0, end);
}

std::string quote(std::string_view text) {
  constexpr std::size_t kShown = 60;
  const std::string_view shown = beginning_of(text, kShown);
  return fmt::format("\"{}{}\"", shown, shown.size() < text.size() ? "..." : "");
}

std::string join_names(std::span<const std::string> names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string nearest_name(std::string_view name, std::span<const std::string> names) {
  constexpr std::size_t kLongest = 80;  // no known name is longer
  if (name.empty() || name.size() > kLongest) return "";
  std::string nearest;
  std::size_t least = std::max<std::size_t>(name.size() > 2 ? 1 : 0, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const std::size_t edits = candidate.starts_with(name) ? 0 : distance(name, candidate);
    if (edits >= least) continue;
    least = edits;
    nearest = candidate;
  }
  return nearest;
}

std::string suggest_names(std::string_view name, std::span<const std::string> names) {
  const std::string nearest = nearest_name(name, names);
  if (nearest.empty()) return fmt::format("allowed are {}", join_names(names));
  constexpr std::size_t kMostListed = 30;  // a longer list would hide the question
  if (names.size() > kMostListed) return fmt::format("did you mean {}?", quote(nearest));
  return fmt::format("did you mean {}? Allowed are {}", quote(nearest), join_names(names));
}

namespace {

// A file descriptor that closes itself.
struct OpenFile {
  int descriptor = -1;
  explicit OpenFile(int number) : descriptor(number) {}
  ~OpenFile() {
    if (descriptor >= 0) close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
};

// Reads at most `most` bytes; false if that fails.
bool read_bytes(int descriptor, std::size_t most, std::string& text) {
  std::array<char, 1 << 14> chunk;
  while (text.size() < most) {
    const ssize_t count =
        ::read(descriptor, chunk.data(), std::min(chunk.size(), most - text.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    text.append(chunk.data(), static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

TextFile read_text_file(const std::filesystem::path& file, std::size_t limit) {
  // A pipe without a writer is opened at once, and refused below.
  const OpenFile open_file(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  if (open_file.descriptor < 0) {
    const bool is_gone = errno == ENOENT || errno == ENOTDIR;
    return is_gone ? TextFile{{}, "there is no such file", "check the path's spelling"}
                   : TextFile{{}, "the file cannot be opened", "check its permissions"};
  }
  struct stat status {};
  if (fstat(open_file.descriptor, &status) != 0 || !S_ISREG(status.st_mode))
    return {{}, "this is no regular file", "name a regular file"};
  // Files of the system, such as /proc/kmsg, have no size, and may have no end.
  if (status.st_size == 0) return {"", "", ""};
  const TextFile too_large{{}, fmt::format("larger than {} bytes", limit), "make the file smaller"};
  if (static_cast<std::uint64_t>(status.st_size) > limit) return too_large;
  // Reading one byte more than allowed detects a file that grows meanwhile.
  std::string text;
  text.reserve(static_cast<std::size_t>(status.st_size) + 1);
  if (!read_bytes(open_file.descriptor, limit + 1, text))
    return {{}, "the file cannot be read", "check the disk and its permissions"};
  if (text.size() > limit) return too_large;
  return {std::move(text), "", ""};
}

}  // namespace edgecase
