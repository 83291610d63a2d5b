// SPDX-License-Identifier: MIT
//
// The command line that explains a case, for people to copy.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace edgecase {

struct ExplainCommand {
  std::string file;                          // of the case, as given
  std::string id;                            // of the case
  std::string renderer;                      // as the command line names it
  std::string policy;                        // name
  std::optional<std::pair<int, int>> pixel;  // column and row, y up
};

// "edgecase explain FILE …", on one line; words are quoted for a POSIX shell if necessary.
std::string command_line(const ExplainCommand& command);

// A word, quoted for a POSIX shell if necessary.
std::string shell_word(const std::string& text);

}  // namespace edgecase
