// SPDX-License-Identifier: MIT
#include "recording/bytes.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace edgecase::recording {

namespace {

constexpr unsigned kBits = 7;
// Deflate makes at most 1032 bytes of one, so a few megabytes could demand all memory.
constexpr std::uint64_t kLargestRatio = 1040;

const Bytef* data_of(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

void write_size(std::uint64_t size, std::string& out) {
  for (; size >= (1u << kBits); size >>= kBits) out += static_cast<char>((size & 0x7f) | 0x80);
  out += static_cast<char>(size);
}

std::uint64_t read_size(std::string_view& bytes) {
  std::uint64_t size = 0;
  for (unsigned shift = 0; shift < 64 && !bytes.empty(); shift += kBits) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    size |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return size;
  }
  throw std::runtime_error("a size does not end");
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, data_of(bytes), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("there is no memory to deflate");
  out.resize(size);
  return out;
}

void write_stretch(std::size_t size, std::string_view deflated, std::string& out) {
  write_size(size, out);
  write_size(deflated.size(), out);
  out += deflated;
}

void write_deflated(std::string_view bytes, std::string& out) {
  write_stretch(bytes.size(), deflated(bytes), out);
}

std::string read_deflated(std::string_view& bytes, std::uint64_t most) {
  const std::uint64_t size = read_size(bytes);
  const std::uint64_t taken = read_size(bytes);
  if (taken > bytes.size() || size / kLargestRatio > taken)
    throw std::runtime_error("a stretch is longer than what there is");
  if (size > most)
    throw std::runtime_error(
        fmt::format("a stretch has {} bytes, and its scenes can need {}", size, most));
  std::string out(size, '\0');
  uLongf written = out.size();
  if (uncompress(reinterpret_cast<Bytef*>(out.data()), &written, data_of(bytes), taken) != Z_OK ||
      written != size)
    throw std::runtime_error("a stretch cannot be inflated");
  bytes.remove_prefix(taken);
  return out;
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(crc32_z(before, data_of(bytes), bytes.size()));
}

namespace {

// How a column is stored, which is its first byte. Steps are differences from the previous number;
// the one before the first is 0.
enum class Coding : unsigned char {
  bytes,
  byte_steps,
  whole,
  whole_steps,
  binary32,
  binary32_steps,
  binary64,
  binary64_steps,
};
constexpr int kCodings = 8;

constexpr double kLargestInteger = 9007199254740992.0;  // 2^53

// Maps small numbers of either sign to small numbers.
template <std::unsigned_integral Bits>
Bits folded(Bits step) {
  const auto sign = static_cast<Bits>(step >> (8 * sizeof(Bits) - 1));
  return static_cast<Bits>(static_cast<Bits>(step << 1) ^ static_cast<Bits>(Bits{0} - sign));
}
template <std::unsigned_integral Bits>
Bits unfolded(Bits value) {
  return static_cast<Bits>((value >> 1) ^ static_cast<Bits>(Bits{0} - (value & 1)));
}

template <std::unsigned_integral Bits>
std::vector<Bits> steps_of(std::vector<Bits> values) {
  Bits before = 0;
  for (Bits& value : values) {
    const Bits step = folded(static_cast<Bits>(value - before));
    before = value;
    value = step;
  }
  return values;
}

std::vector<std::uint64_t> folds_of(std::vector<std::uint64_t> values) {
  for (std::uint64_t& value : values) value = folded(value);
  return values;
}

template <std::unsigned_integral Bits>
std::vector<Bits> sums_of(std::vector<Bits> steps) {
  Bits before = 0;
  for (Bits& step : steps) step = before = static_cast<Bits>(before + unfolded(step));
  return steps;
}

// All first bytes, the highest ones, then all second bytes, and so on.
template <std::unsigned_integral Bits>
std::string planes_of(const std::vector<Bits>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(Bits));
  for (unsigned shift = 8 * sizeof(Bits); shift > 0;) {
    shift -= 8;
    for (const Bits value : values) bytes += static_cast<char>((value >> shift) & 0xff);
  }
  return bytes;
}

template <std::unsigned_integral Bits>
std::vector<Bits> from_planes(std::string_view bytes) {
  if (bytes.size() % sizeof(Bits) != 0) throw std::runtime_error("a number is cut off");
  const std::size_t count = bytes.size() / sizeof(Bits);
  std::vector<Bits> values(count);
  for (std::size_t plane = 0; plane < sizeof(Bits); ++plane)
    for (std::size_t i = 0; i < count; ++i)
      values[i] = static_cast<Bits>((std::uint64_t{values[i]} << 8) |
                                    static_cast<unsigned char>(bytes[plane * count + i]));
  return values;
}

std::string sizes_of(const std::vector<std::uint64_t>& values) {
  std::string bytes;
  for (const std::uint64_t value : values) write_size(value, bytes);
  return bytes;
}

std::vector<std::uint64_t> from_sizes(std::string_view bytes, std::uint64_t most) {
  std::vector<std::uint64_t> values;
  for (; !bytes.empty(); values.push_back(read_size(bytes)))
    if (values.size() == most) throw std::runtime_error("a column has too many numbers");
  return values;
}

bool is_whole(double value) {
  return std::abs(value) < kLargestInteger && value == std::trunc(value);
}

bool is_byte(double value) {
  return is_whole(value) && value >= 0 && value <= 255;
}

bool is_binary32(double value) {
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
         static_cast<double>(static_cast<float>(value)) == value;
}

std::int64_t to_whole(double value) {
  return static_cast<std::int64_t>(value);
}

// The bits of each number in the given type.
template <class Bits, class To>
std::vector<Bits> bits_of(const std::vector<double>& column, To to_bits) {
  std::vector<Bits> values(column.size());
  std::transform(column.begin(), column.end(), values.begin(), to_bits);
  return values;
}

template <class Bits, class From>
std::vector<double> numbers_of(const std::vector<Bits>& values, From from_bits) {
  std::vector<double> column(values.size());
  std::transform(values.begin(), values.end(), column.begin(), from_bits);
  return column;
}

double from_byte(std::uint8_t bits) {
  return static_cast<double>(bits);
}
double from_whole(std::uint64_t bits) {
  return static_cast<double>(static_cast<std::int64_t>(bits));
}
double from_binary32(std::uint32_t bits) {
  return static_cast<double>(std::bit_cast<float>(bits));
}
double from_binary64(std::uint64_t bits) {
  return std::bit_cast<double>(bits);
}

// The most bytes that a number takes.
std::uint64_t width_of(Coding coding) {
  constexpr std::uint64_t kOfSize = 10;
  switch (coding) {
    case Coding::bytes:
    case Coding::byte_steps:
      return 1;
    case Coding::whole:
    case Coding::whole_steps:
      return kOfSize;
    case Coding::binary32:
    case Coding::binary32_steps:
      return sizeof(float);
    case Coding::binary64:
    case Coding::binary64_steps:
      return sizeof(double);
  }
  return 1;
}

// Keeps the smaller of the offered codings.
class Choice {
 public:
  void offer(Coding coding, const std::string& bytes) {
    std::string packed = deflated(bytes);
    if (size_ != 0 && packed.size() >= packed_.size()) return;
    coding_ = coding;
    size_ = bytes.size();
    packed_ = std::move(packed);
  }
  void write(std::string& out) const {
    out += static_cast<char>(coding_);
    write_stretch(size_, packed_, out);
  }

 private:
  Coding coding_ = Coding::whole;
  std::size_t size_ = 0;
  std::string packed_;
};

}  // namespace

void write_column(const std::vector<double>& column, std::string& out) {
  Choice choice;
  if (std::all_of(column.begin(), column.end(), is_byte)) {
    const auto values = bits_of<std::uint8_t>(
        column, [](double value) { return static_cast<std::uint8_t>(to_whole(value)); });
    choice.offer(Coding::bytes, planes_of(values));
    choice.offer(Coding::byte_steps, planes_of(steps_of(values)));
  } else if (std::all_of(column.begin(), column.end(), is_whole)) {
    const auto values = bits_of<std::uint64_t>(
        column, [](double value) { return static_cast<std::uint64_t>(to_whole(value)); });
    choice.offer(Coding::whole, sizes_of(folds_of(values)));
    choice.offer(Coding::whole_steps, sizes_of(steps_of(values)));
  } else if (std::all_of(column.begin(), column.end(), is_binary32)) {
    const auto values = bits_of<std::uint32_t>(column, [](double value) {
      return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    });
    choice.offer(Coding::binary32, planes_of(values));
    choice.offer(Coding::binary32_steps, planes_of(steps_of(values)));
  } else {
    const auto values = bits_of<std::uint64_t>(
        column, [](double value) { return std::bit_cast<std::uint64_t>(value); });
    choice.offer(Coding::binary64, planes_of(values));
    choice.offer(Coding::binary64_steps, planes_of(steps_of(values)));
  }
  choice.write(out);
}

std::vector<double> read_column(std::string_view& bytes, std::uint64_t most) {
  if (bytes.empty()) throw std::runtime_error("a column is missing");
  const auto number = static_cast<unsigned char>(bytes.front());
  if (number >= kCodings) throw std::runtime_error("a column is coded in an unknown way");
  bytes.remove_prefix(1);
  const auto coding = static_cast<Coding>(number);
  const std::string values = read_deflated(bytes, most * width_of(coding));
  switch (coding) {
    case Coding::bytes:
      return numbers_of(from_planes<std::uint8_t>(values), from_byte);
    case Coding::byte_steps:
      return numbers_of(sums_of(from_planes<std::uint8_t>(values)), from_byte);
    case Coding::whole:
      return numbers_of(from_sizes(values, most),
                        [](std::uint64_t bits) { return from_whole(unfolded(bits)); });
    case Coding::whole_steps:
      return numbers_of(sums_of(from_sizes(values, most)), from_whole);
    case Coding::binary32:
      return numbers_of(from_planes<std::uint32_t>(values), from_binary32);
    case Coding::binary32_steps:
      return numbers_of(sums_of(from_planes<std::uint32_t>(values)), from_binary32);
    case Coding::binary64:
      return numbers_of(from_planes<std::uint64_t>(values), from_binary64);
    case Coding::binary64_steps:
      return numbers_of(sums_of(from_planes<std::uint64_t>(values)), from_binary64);
  }
  return {};
}

}  // namespace edgecase::recording
