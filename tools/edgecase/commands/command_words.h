// SPDX-License-Identifier: MIT
//
// A description of the command line: subcommands, their options and values, read from the parser
// itself, so that the manual page and the completions always agree with it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace edgecase {

struct OptionWords {
  std::vector<std::string> names;  // "--output", "-o"; of a positional argument: one name
  std::string description;
  bool takes_value = false;
  bool is_positional = false;
  bool is_required = false;
  bool is_repeatable = false;
  std::string default_value;         // empty: none
  std::string range;                 // "[1 - 256]", or empty
  std::vector<std::string> choices;  // all accepted values, or suggestions; empty: no list
};

struct CommandWords {
  std::string name;
  std::string description;
  std::vector<OptionWords> options;  // in the order of the help
};

// All subcommands, in the order of the help.
std::vector<CommandWords> words_of(const CLI::App& app);

}  // namespace edgecase
