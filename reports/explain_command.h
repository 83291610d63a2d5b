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

// "edgecase explain FILE …", on one line, every word quoted for a POSIX shell where it has to be.
std::string words_of(const ExplainCommand& command);

// A word as a POSIX shell takes it literally.
std::string shell_word(const std::string& text);

}  // namespace edgecase
