// SPDX-License-Identifier: MIT
#include "tools/edgecase/trust.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gcrypt.h>
#include <unistd.h>

#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "reports/text.h"
#include "run/renderers.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/private_folder.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

// 64 hexadecimal digits. Nobody can make a second text with the same ones.
std::string sha256(const std::string& text) {
  // What the library asks every program to call first.
  gcry_check_version(nullptr);
  gcry_control(GCRYCTL_DISABLE_SECMEM, 0);
  gcry_control(GCRYCTL_INITIALIZATION_FINISHED, 0);
  std::array<unsigned char, 32> bytes{};
  gcry_md_hash_buffer(GCRY_MD_SHA256, bytes.data(), text.data(), text.size());
  std::string digest;
  for (const unsigned byte : bytes) digest += fmt::format("{:02x}", byte);
  return digest;
}

// What is remembered of a project whose programs may be run.
class Word {
 public:
  explicit Word(const Project& project)
      : text_(project.file.string() + "\n"),
        digest_(sha256(project.file.string() + '\0' + project.text)),
        folder_(private_folder("trusted")) {}

  bool is_remembered() const {
    constexpr std::size_t kMost = 1 << 16;
    const auto* folder = std::get_if<fs::path>(&folder_);
    return folder != nullptr && read_private_file(*folder / digest_, kMost) == text_;
  }

  void remember() const {
    const auto* folder = std::get_if<fs::path>(&folder_);
    if (folder != nullptr && write_private_file(*folder / digest_, text_)) return;
    print_error(fmt::format("this is not remembered: {}",
                            folder == nullptr ? std::get<std::string>(folder_)
                                              : folder->string() + " cannot be written"));
  }

 private:
  std::string text_;
  std::string digest_;
  std::variant<fs::path, std::string> folder_;
};

// All that the file names, since the word is about all of it.
std::vector<std::string> foreign_code(const Project& project) {
  std::vector<std::string> all;
  for (const auto& [name, address] : project.renderers)
    if (is_foreign_code(address)) all.push_back(fmt::format("{} = {}", name, address));
  return all;
}

bool has_terminal() {
  return isatty(STDIN_FILENO) == 1 && isatty(STDERR_FILENO) == 1;
}

bool says_yes(const Project& project) {
  print_to_stderr(one_line(project.file.string()) + " names what this command runs as you:\n");
  for (const std::string& one : foreign_code(project)) print_to_stderr("  " + one_line(one) + "\n");
  print_to_stderr("Start them? [y/N] ");
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "Y" || answer == "yes";
}

}  // namespace

void require_trust(const Project& project, bool is_given) {
  std::optional<Word> word;
  if (!project.is_writable_by_others) word.emplace(project);
  if (word && word->is_remembered()) return;
  if (!is_given && !(has_terminal() && says_yes(project)))
    throw ProjectError(fmt::format(
        "{}: it names what you have not allowed to run: {}; allow it with --trust, which {}",
        project.file.string(), fmt::join(foreign_code(project), ", "),
        word ? "is remembered until the file changes"
             : "is not remembered, since others can write the file"));
  if (word) word->remember();
}

}  // namespace edgecase
