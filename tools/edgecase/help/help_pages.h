// SPDX-License-Identifier: MIT
//
// Help pages: the text below the options in the help of a subcommand, with exit codes and examples.
// The manual page uses the same pages and options.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace edgecase {

struct HelpPage {
  const char* name;      // of the subcommand
  const char* group;     // heading under which the program's help lists it
  const char* purpose;   // a paragraph that continues its one-line description
  const char* exits;     // its possible exit codes, a digit each
  const char* code_one;  // the meaning of 1 here; nullptr: it does not occur
  const char* examples;  // command lines, one each line
};

// The pages of all subcommands, by group, in the order of help and manual.
std::span<const HelpPage> help_pages();

// The page of a subcommand; throws std::out_of_range if there is none.
const HelpPage& help_page(const std::string& name);

// "0 as expected", for each of the page's codes.
std::vector<std::string> exit_code_lines(const HelpPage& page);

// Sets the group of every subcommand, adds its page below its help, and makes help as wide as the
// terminal. Call it after adding all subcommands.
void add_help_pages(CLI::App& app);

}  // namespace edgecase
