// SPDX-License-Identifier: MIT
#include "reports/explain_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "reports/text.h"

namespace edgecase {

std::string command_line(const ExplainCommand& command) {
  std::string words = "edgecase explain " + shell_word(command.file);
  // The file expands to several cases, of which this is one.
  if (command.id.find(':') != std::string::npos) words += " --filter " + shell_word(command.id);
  words += " --against " + shell_word(command.renderer);
  if (command.pixel)
    words += fmt::format(" --pixel {},{}", command.pixel->first, command.pixel->second);
  if (command.policy != "opengl") words += " --policy " + shell_word(command.policy);
  return one_line(words);
}

std::string shell_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_@%+=:,./-").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace edgecase
