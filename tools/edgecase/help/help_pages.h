// SPDX-License-Identifier: MIT
//
// Help pages: what the help of a subcommand says below its options, its exit codes and examples.
// The manual page and the help are made of the same pages and options.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace edgecase {

struct HelpPage {
  const char* name;      // of the subcommand
  const char* group;     // heading under which the program's help lists it
  const char* purpose;   // a paragraph on what its one-line description leaves open
  const char* exits;     // the exit codes it may end with, a digit each
  const char* code_one;  // what 1 means here; nullptr: it does not occur
  const char* examples;  // command lines, one each line
};

// One for every subcommand, group by group, in the order in which help and manual list them.
std::span<const HelpPage> help_pages();

// The page of a subcommand; throws std::out_of_range where there is none.
const HelpPage& help_page(const std::string& name);

// "0 as expected", for each of the page's codes.
std::vector<std::string> exit_code_lines(const HelpPage& page);

// Puts every subcommand into its group, and its page below its help. Makes help as wide as the
// terminal. Call it when all are added.
void add_help_pages(CLI::App& app);

}  // namespace edgecase
