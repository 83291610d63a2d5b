// SPDX-License-Identifier: MIT
#include "tools/edgecase/results_key.h"

#include <gcrypt.h>
#include <sys/random.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <streambuf>
#include <utility>

#include "tools/edgecase/private_folder.h"

namespace edgecase {
namespace {

constexpr std::size_t kKeySize = 32;
constexpr std::size_t kMostRemembered = 4096;  // 128 KiB

// What the library asks every program to call first.
void begin_library() {
  [[maybe_unused]] static const bool is_begun = [] {
    gcry_check_version(nullptr);
    gcry_control(GCRYCTL_DISABLE_SECMEM, 0);
    gcry_control(GCRYCTL_INITIALIZATION_FINISHED, 0);
    return true;
  }();
}

std::optional<std::string> random_key() {
  std::string key(kKeySize, '\0');
  for (;;) {
    const ssize_t got = getrandom(key.data(), key.size(), 0);
    if (got == static_cast<ssize_t>(key.size())) return key;
    if (got >= 0 || errno != EINTR) return std::nullopt;
  }
}

// The codes that are remembered, the latest one last.
std::string codes_in(const std::string& file) {
  std::string codes = read_private_file(file, kMostRemembered * ResultsKey::kCodeSize).value_or("");
  codes.resize(codes.size() / ResultsKey::kCodeSize * ResultsKey::kCodeSize);
  return codes;
}

// Where a code begins in others, or npos.
std::size_t find_code(const std::string& codes, const std::string& code) {
  for (std::size_t at = 0; at < codes.size(); at += code.size())
    if (codes.compare(at, code.size(), code) == 0) return at;
  return std::string::npos;
}

}  // namespace

ResultsKey::ResultsKey(std::string folder, std::string key)
    : folder_(std::move(folder)), key_(std::move(key)) {}

std::variant<ResultsKey, std::string> ResultsKey::of_user() {
  auto folder = private_folder("results");
  if (auto* fault = std::get_if<std::string>(&folder)) return std::move(*fault);
  const std::string path = std::get<std::filesystem::path>(folder).string();
  const std::string file = path + "/key";
  auto key = read_private_file(file, kKeySize);
  if (!key || key->size() != kKeySize) {
    const auto made = random_key();
    // Of two runs that make one at once the first wins.
    if (made) write_private_file(file, *made, Existing::kept);
    key = read_private_file(file, kKeySize);
  }
  if (!key || key->size() != kKeySize)
    return "the key " + file + " cannot be read or made, or others may read it; remove it";
  return ResultsKey(path, std::move(*key));
}

struct ResultsKey::Coder::State {
  gcry_md_hd_t handle = nullptr;
};

ResultsKey::Coder::Coder(const ResultsKey& key) : state_(new State) {
  begin_library();
  if (gcry_md_open(&state_->handle, GCRY_MD_SHA256, GCRY_MD_FLAG_HMAC) != 0 ||
      gcry_md_setkey(state_->handle, key.key_.data(), key.key_.size()) != 0)
    throw std::runtime_error("libgcrypt has no HMAC-SHA256 here");
}

ResultsKey::Coder::~Coder() {
  gcry_md_close(state_->handle);
}

ResultsKey::Coder& ResultsKey::Coder::add(std::string_view bytes) {
  gcry_md_write(state_->handle, bytes.data(), bytes.size());
  return *this;
}

std::string ResultsKey::Coder::code() {
  const void* const bytes = gcry_md_read(state_->handle, GCRY_MD_SHA256);
  std::string code(static_cast<const char*>(bytes), kCodeSize);
  gcry_md_reset(state_->handle);  // the key stays
  return code;
}

bool ResultsKey::remembers(const std::string& code) const {
  return find_code(codes_in(folder_ + "/written"), code) != std::string::npos;
}

void ResultsKey::remember(const std::string& code) const {
  const std::string file = folder_ + "/written";
  std::string codes = codes_in(file);
  if (const auto at = find_code(codes, code); at != std::string::npos) codes.erase(at, code.size());
  codes += code;
  constexpr std::size_t kMost = kMostRemembered * kCodeSize;
  if (codes.size() > kMost) codes.erase(0, codes.size() - kMost);
  write_private_file(file, codes);
}

class CodedStream::Buffer : public std::streambuf {
 public:
  Buffer(std::ostream& out, const ResultsKey& key) : out_(out), coder_(key) {}
  std::string code() { return coder_.code(); }

 private:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    coder_.add({bytes, static_cast<std::size_t>(count)});
    return out_.write(bytes, count) ? count : 0;
  }
  int_type overflow(int_type byte) override {
    const char one = traits_type::to_char_type(byte);
    return xsputn(&one, 1) == 1 ? byte : traits_type::eof();
  }

  std::ostream& out_;
  ResultsKey::Coder coder_;
};

CodedStream::CodedStream(std::ostream& to, const ResultsKey& key)
    : std::ostream(nullptr), buffer_(new Buffer(to, key)) {
  rdbuf(buffer_.get());
}

CodedStream::~CodedStream() = default;

std::string CodedStream::code() {
  return buffer_->code();
}

}  // namespace edgecase
