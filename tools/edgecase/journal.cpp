// SPDX-License-Identifier: MIT
#include "tools/edgecase/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "results/results_json.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// The first bytes of a skippable frame that holds a code: its magic number, and its size.
constexpr std::string_view kCodeHead("\x50\x2a\x4d\x18\x20\0\0\0", 8);

// Bytes: all that is read of a journal before it is known to be the user's own, and of any.
constexpr std::size_t kBeginning = std::size_t{1} << 20;
constexpr std::size_t kLargest = std::size_t{1} << 30;

// The next bytes of a file, at most so many.
std::string bytes_of(std::istream& file, std::size_t most) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::string bytes;
  for (std::size_t got = kPiece; got == kPiece && bytes.size() < most;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kPiece);
    file.read(bytes.data() + before, kPiece);
    got = static_cast<std::size_t>(file.gcount());
    bytes.resize(before + got);
  }
  return bytes;
}

// A device or a pipe has no journal.
bool may_have_journal(const fs::path& results) {
  std::error_code error;
  const fs::file_status status = fs::status(results, error);
  return !results.empty() && (!fs::exists(status) || fs::is_regular_file(status));
}

// Does this header know of fewer renderers what they are?
bool knows_less(const std::vector<RendererInfo>& now, const std::vector<RendererInfo>& before) {
  return !std::ranges::equal(now, before, [](const RendererInfo& one, const RendererInfo& other) {
    return !has_never_answered(one) || has_never_answered(other);
  });
}

// The bytes of whole frames at the beginning. Sets `is_own`: all have their codes.
std::size_t size_of_whole_frames(std::string_view bytes, const ResultsKey* key, bool& is_own) {
  std::optional<ResultsKey::Coder> coder;
  if (key != nullptr) coder.emplace(*key);
  is_own = key != nullptr;
  std::string last_code;
  std::size_t whole = 0;
  for (std::string_view left = bytes; !left.empty(); left = bytes.substr(whole)) {
    const std::size_t size = ZSTD_findFrameCompressedSize(left.data(), left.size());
    if (ZSTD_isError(size) != 0) break;
    const std::string_view frame = left.substr(0, size);
    left.remove_prefix(size);
    std::string code;
    if (left.starts_with(kCodeHead)) {
      if (left.size() < kCodeHead.size() + ResultsKey::kCodeSize) break;
      code = left.substr(kCodeHead.size(), ResultsKey::kCodeSize);
    } else if (is_own && whole > 0 && kCodeHead.starts_with(left)) {
      break;  // the frames before have codes, and this one's is cut off
    }
    is_own = is_own && coder->add(last_code).add(frame).code() == code;
    last_code = code;
    whole += size + (code.empty() ? 0 : kCodeHead.size() + code.size());
  }
  return whole;
}

}  // namespace

fs::path journal_of(const fs::path& results) {
  return results.string() + ".unfinished";
}

struct Journal::Packer {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  std::string packed;

  Packer() {
    if (context == nullptr) throw std::runtime_error("there is no memory to pack results");
    ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, 1);
    ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  }
  ~Packer() { ZSTD_freeCCtx(context); }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  // The frame of a text, until the next call.
  std::string& frame_of(const std::string& text) {
    packed.resize(ZSTD_compressBound(text.size()));
    const std::size_t size =
        ZSTD_compress2(context, packed.data(), packed.size(), text.data(), text.size());
    if (ZSTD_isError(size) != 0) throw std::runtime_error("there is no memory to pack results");
    packed.resize(size);
    return packed;
  }
};

Journal::Journal(const fs::path& results, const ResultsKey* key)
    : path_(may_have_journal(results) ? journal_of(results) : fs::path()), packer_(new Packer) {
  if (key != nullptr) coder_.emplace(*key);
}

Journal::~Journal() {
  if (file_ >= 0) close(file_);
}

void Journal::open_beside() {
  if (path_.empty()) return;
  std::error_code error;
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
  beside_ = path_.parent_path() / fmt::format(".edgecase-{}.part", getpid());
  unlink(beside_.c_str());  // of another process with this number, long ago
  file_ = open(beside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
}

// A link of this name is replaced, and not followed.
void Journal::take_place() {
  if (file_ >= 0 && std::rename(beside_.c_str(), path_.c_str()) != 0) remove();
}

void Journal::start() {
  open_beside();
  take_place();
}

void Journal::hold(const Results& earlier) {
  open_beside();
  renderers_ = earlier.renderers;
  if (file_ >= 0) write_frame(header_line(earlier));
  for (const CaseResults& one : earlier.cases) add(one);
  take_place();
}

void Journal::begin(const Results& run) {
  if (file_ < 0 || (!renderers_.empty() && knows_less(run.renderers, renderers_))) return;
  renderers_ = run.renderers;
  Results told = run;
  told.tool = kToolName;
  write_frame(header_line(told));
}

void Journal::add(const CaseResults& one) {
  if (file_ >= 0) write_frame(case_lines(one, heads_++, renderers_));
}

void Journal::write_frame(const std::string& text) {
  std::string& frame = packer_->frame_of(text);
  if (coder_) {
    last_code_ = coder_->add(last_code_).add(frame).code();
    frame.append(kCodeHead).append(last_code_);
  }
  for (std::string_view left = frame; !left.empty();) {
    const ssize_t wrote = write(file_, left.data(), left.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return remove();
    left.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

bool Journal::is_at(const fs::path& path) const {
  struct stat ours {};
  struct stat there {};
  return file_ >= 0 && fstat(file_, &ours) == 0 && lstat(path.c_str(), &there) == 0 &&
         ours.st_dev == there.st_dev && ours.st_ino == there.st_ino;
}

// Another run into the same file may have put its own there.
void Journal::remove() {
  for (const fs::path& path : {path_, beside_})
    if (is_at(path)) unlink(path.c_str());
  if (file_ >= 0) close(std::exchange(file_, -1));
}

std::variant<JournalRead, std::string> read_journal(const fs::path& path, const ResultsKey* key,
                                                    bool is_named) {
  JournalRead read;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fmt::format("cannot read {}", path.string());
  std::string bytes = bytes_of(file, kBeginning);
  if (bytes.empty()) return JournalRead{std::nullopt, true};
  const std::size_t known = size_of_whole_frames(bytes, key, read.is_own);
  const bool is_long = bytes.size() == kBeginning;
  if (!is_named && (!read.is_own || (known == 0 && is_long))) return JournalRead{};
  if (is_long) bytes += bytes_of(file, kLargest);
  bytes.resize(size_of_whole_frames(bytes, key, read.is_own));
  if (bytes.empty()) return JournalRead{std::nullopt, true};
  if (!is_named && !read.is_own) return read;
  auto results = read_results(bytes, Cut::kept);
  if (auto* fault = std::get_if<std::string>(&results))
    return fmt::format("{}: {}; or remove it to run all", path.string(), *fault);
  if (!std::get<Results>(results).cases.empty())
    read.run = MergePart{path.string(), std::move(std::get<Results>(results))};
  return read;
}

}  // namespace edgecase
