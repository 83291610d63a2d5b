// SPDX-License-Identifier: MIT
#include "results/shelf.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <deque>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace edgecase {
namespace {

constexpr int kLevel = -3;                               // packing is to cost nearly nothing
constexpr std::size_t kInMemory = std::size_t{1} << 20;  // bytes that are not written yet

// Where TMPDIR names none that is there, std::filesystem names none either.
std::string folder() {
  const char* const named = std::getenv("TMPDIR");
  return named != nullptr && *named != '\0' ? named : "/tmp";
}

[[noreturn]] void refuse(const char* what, int error) {
  throw ShelfError(fmt::format("results cannot be {} {}: {}; name a folder that has room in TMPDIR",
                               what, folder(), std::generic_category().message(error)));
}

int open_nameless_file() {
  std::string name = folder() + "/edgecase-XXXXXX";
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) refuse("kept in", errno);
  unlink(name.c_str());
  return file;
}

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

struct Shelf::State {
  std::mutex mutex;
  std::unique_ptr<ZSTD_CCtx, FreeContext> packer{ZSTD_createCCtx()};
  std::string packed;                                  // the last bytes that were put
  std::string latest;                                  // what the file does not have yet
  std::uint64_t in_file = 0;                           // bytes
  std::deque<std::pair<std::string, Place>> repeated;  // the last of put_repeated
  int file = -1;

  ~State() {
    if (file >= 0) close(file);
  }

  void write_latest() {
    if (file < 0) file = open_nameless_file();
    std::uint64_t end = in_file;
    for (std::string_view left = latest; !left.empty();) {
      const ssize_t wrote = pwrite(file, left.data(), left.size(), static_cast<off_t>(end));
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote < 0) refuse("kept in", errno);
      left.remove_prefix(static_cast<std::size_t>(wrote));
      end += static_cast<std::uint64_t>(wrote);
    }
    in_file = end;
    latest.clear();
  }
};

Shelf::Shelf() : state_(new State) {}

Shelf::~Shelf() = default;

Shelf::Place Shelf::put(std::string_view bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max() / 2)
    throw std::runtime_error("the results of one case are too large");
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  s.packed.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compressCCtx(s.packer.get(), s.packed.data(), s.packed.size(),
                                             bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error("there is no memory to pack results");
  if (s.latest.size() + size > kInMemory) s.write_latest();
  const Place place{s.in_file + s.latest.size(), static_cast<std::uint32_t>(size),
                    static_cast<std::uint32_t>(bytes.size())};
  s.latest.append(s.packed, 0, size);
  return place;
}

Shelf::Place Shelf::put_repeated(const std::string& bytes) {
  constexpr std::size_t kMost = 8;  // threads put those of several files in turn
  State& s = *state_;
  {
    const std::lock_guard lock(s.mutex);
    const auto found = std::ranges::find(s.repeated, bytes, &std::pair<std::string, Place>::first);
    if (found != s.repeated.end()) return found->second;
  }
  const Place place = put(bytes);
  const std::lock_guard lock(s.mutex);
  if (s.repeated.size() == kMost) s.repeated.pop_front();
  s.repeated.emplace_back(bytes, place);
  return place;
}

std::string Shelf::at(const Place& place) const {
  State& s = *state_;
  std::string packed(place.packed, '\0');
  {
    const std::lock_guard lock(s.mutex);
    if (place.begin >= s.in_file) packed.assign(s.latest, place.begin - s.in_file, place.packed);
    for (std::size_t read = place.begin >= s.in_file ? packed.size() : 0; read < packed.size();) {
      const ssize_t count = pread(s.file, packed.data() + read, packed.size() - read,
                                  static_cast<off_t>(place.begin + read));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) refuse("read back from", count < 0 ? errno : EIO);
      read += static_cast<std::size_t>(count);
    }
  }
  thread_local const std::unique_ptr<ZSTD_DCtx, FreeContext> unpacker(ZSTD_createDCtx());
  std::string bytes(place.unpacked, '\0');
  if (ZSTD_decompressDCtx(unpacker.get(), bytes.data(), bytes.size(), packed.data(),
                          packed.size()) != bytes.size())
    throw std::runtime_error("results that were put aside are damaged");
  return bytes;
}

}  // namespace edgecase
