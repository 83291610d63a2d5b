// SPDX-License-Identifier: MIT
//
// Help as wide as the terminal, broken between words.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <string_view>

namespace edgecase {

// The width of help in columns: that of the terminal, or the variable COLUMNS, or 80; limited to 40
// to 100, since longer lines are hard to read.
std::size_t help_width();

// The text in lines of at most `width` columns, all but the first with `indent` spaces in front.
// A line break in the text ends a line; a line that begins with a space is left as it is. Words
// longer than a line are not broken. Columns are counted as bytes: help is ASCII.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

class WrappedFormatter : public CLI::Formatter {
 public:
  explicit WrappedFormatter(std::size_t width);

  std::string make_description(const CLI::App* app) const override;
  std::string make_footer(const CLI::App* app) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  // The text behind an option's name: "TEXT ..." if it takes values.
  std::string make_option_opts(const CLI::Option* option) const override;
  // Its meaning, values and default, and the options that it needs or excludes.
  std::string make_option_desc(const CLI::Option* option) const override;

 private:
  // A name, and in the second column its meaning.
  std::string entry(const std::string& name, const std::string& description) const;

  std::size_t width_;
};

}  // namespace edgecase
