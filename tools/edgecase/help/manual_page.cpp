// SPDX-License-Identifier: MIT
#include "tools/edgecase/help/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "tools/edgecase/help/help_pages.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

// A text escaped for man(7): no escapes, no requests, hyphens that can be copied.
std::string literal(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// The placeholder of an option's value: JUNIT for --junit.
std::string value_word(const OptionWords& option) {
  std::string name = option.names.front();
  name.erase(0, name.find_first_not_of('-'));
  return upper(name);
}

std::string argument(const OptionWords& option) {
  std::string text = upper(option.names.front()) + (option.is_repeatable ? " ..." : "");
  return option.is_required ? text : "[" + text + "]";
}

std::string entry(const OptionWords& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + literal(option.is_positional ? upper(name) : name);
  std::string text = ".TP\n\\fB" + names + "\\fR";
  if (option.takes_value && !option.is_positional) text += " " + literal(value_word(option));
  text += "\n" + literal(option.description);
  if (option.is_required) text += " (required)";
  if (!option.range.empty()) text += literal(fmt::format("; {}", option.range));
  if (!option.default_value.empty())
    text += literal(fmt::format(" (default: {})", option.default_value));
  // A long list is already in the text, or printed by another subcommand.
  if (!option.choices.empty() && option.choices.size() < 8)
    text += literal(fmt::format(" [{}]", fmt::join(option.choices, ", ")));
  return text + "\n";
}

std::string section(const CommandWords& command) {
  const HelpPage& page = help_page(command.name);
  std::string text =
      fmt::format(".SS edgecase {}\n{}.\n.PP\n{}\n.PP\n\\fBedgecase {}\\fR [options]", command.name,
                  literal(command.description), literal(page.purpose), command.name);
  for (const OptionWords& option : command.options)
    if (option.is_positional) text += " " + literal(argument(option));
  text += "\n";
  for (const OptionWords& option : command.options) text += entry(option);
  text += ".PP\nExit codes:\n";
  for (const std::string& line : exit_code_lines(page)) text += ".br\n" + literal(line) + "\n";
  text += ".PP\nExamples:\n.PP\n.nf\n";
  std::istringstream lines(page.examples);
  for (std::string line; std::getline(lines, line);) text += literal(line) + "\n";
  return text + ".fi\n";
}

}  // namespace

std::string manual_page(const std::string& description, std::span<const CommandWords> commands) {
  std::string text = fmt::format(
      ".TH EDGECASE 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\nedgecase \\- exact rasterization, "
      "held "
      "against real OpenGL\n.SH SYNOPSIS\n\\fBedgecase\\fR SUBCOMMAND [options] [arguments]\n"
      ".SH DESCRIPTION\n{}\n.PP\nWithout a path, cases are those of the folder cases here, or of "
      "the installed suite. Ids of cases and globs of ids stand wherever a path of cases may.\n.SH "
      "SUBCOMMANDS\n",
      kToolName, literal(description));
  for (const CommandWords& command : commands) text += section(command);
  text +=
      ".SH ENVIRONMENT\n.TP\nEDGECASE_KERNELS\nThe SIMD target of the fast kernels; none turns "
      "them off. Results are the same.\n"
      ".SH FILES\n.TP\nPREFIX/share/edgecase/cases\nThe suite, with its schema, policies, profiles "
      "and known faults.\n.TP\nPREFIX/share/doc/edgecase\nHow cases are written, and the protocol "
      "of exec: programs.\n";
  return text;
}

}  // namespace edgecase
