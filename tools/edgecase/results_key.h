// SPDX-License-Identifier: MIT
//
// Which results files runs of this user have written: what such a file says may be believed
// although nobody names it.
//
// The user's private folder `results` (private_folder.h) has a `key`, 32 random bytes, and
// `written`: the codes of the files that were written last. A code is HMAC-SHA256 (RFC 2104) of a
// file's bytes under the key. It lies there, and not in the file, so that the same results are the
// same bytes on every machine. Who cannot write into that folder can make no file that is believed.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <variant>

namespace edgecase {

class ResultsKey {
 public:
  static constexpr std::size_t kCodeSize = 32;  // bytes

  // Of this user, made by the first run; or a sentence that says why there is none.
  static std::variant<ResultsKey, std::string> of_user();

  // Makes the code of bytes that come piece by piece.
  class Coder {
   public:
    explicit Coder(const ResultsKey& key);
    ~Coder();
    Coder(const Coder&) = delete;
    Coder& operator=(const Coder&) = delete;
    Coder& add(std::string_view bytes);
    // Of all that was added since the last call.
    std::string code();

   private:
    struct State;
    std::unique_ptr<State> state_;
  };

  // True if remember() got this code, and few enough others since.
  bool remembers(const std::string& code) const;
  // Two runs that call it at once may lose one of their codes: then answers are compared once more.
  void remember(const std::string& code) const;

 private:
  explicit ResultsKey(std::string folder, std::string key);

  std::string folder_;
  std::string key_;
};

// Hands on what is written to another stream, and makes its code.
class CodedStream : public std::ostream {
 public:
  // Both must live as long.
  CodedStream(std::ostream& to, const ResultsKey& key);
  ~CodedStream() override;
  std::string code();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace edgecase
