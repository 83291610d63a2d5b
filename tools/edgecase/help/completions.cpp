// SPDX-License-Identifier: MIT
#include "tools/edgecase/help/completions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace edgecase {
namespace {

// readline ends words at ':' and '='. So the words are taken from the line itself, and the part
// before the last ':' is removed from the answers.
constexpr const char* kBashHead = R"(# Completion of the edgecase command for bash.
_edgecase() {
  local line=${COMP_LINE:0:COMP_POINT} words current previous choices= options= values= prefix
  read -ra words <<< "$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  current=${words[${#words[@]}-1]}
  previous=${words[${#words[@]}-2]}
  COMPREPLY=()
)";
constexpr const char* kBashTail = R"(  if [[ $current == --*=* ]]; then
    previous=${current%%=*}
    current=${current#*=}
  fi
  if (( ${#words[@]} > 2 )); then
    case ${words[1]}:$previous in
CHOICES    esac
    [[ " $values " == *" $previous "* ]] || [[ $current != -* ]] || choices=$options
  fi
  if [[ -n $choices ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current")
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
  if [[ $current == *:* && $COMP_WORDBREAKS == *:* ]]; then
    prefix=${current%"${current##*:}"}
    COMPREPLY=("${COMPREPLY[@]#"$prefix"}")
  fi
}
complete -F _edgecase edgecase
)";

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

// Escapes a text for single quotes.
std::string quoted_for_fish(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string fish_option(const CommandWords& command, const OptionWords& option) {
  std::string line =
      fmt::format("complete -c edgecase -n '__fish_seen_subcommand_from {}'", command.name);
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.takes_value) line += " -r";
  if (!option.choices.empty())
    line += fmt::format(" -f -a {}", quoted_for_fish(joined(option.choices)));
  return line + fmt::format(" -d {}\n", quoted_for_fish(option.description));
}

}  // namespace

std::string bash_completion(std::span<const CommandWords> commands) {
  std::string names = "--help --version";
  std::string cases;
  std::string choices;
  for (const CommandWords& command : commands) {
    names += " " + command.name;
    std::string options;
    std::string values;
    for (const OptionWords& option : command.options) {
      if (option.is_positional) {
        if (!option.choices.empty())
          choices += fmt::format("      {0}:{0}) choices=\"{1}\" ;;\n", command.name,
                                 joined(option.choices));
        continue;
      }
      for (const std::string& name : option.names) {
        options += " " + name;
        if (!option.takes_value) continue;
        values += " " + name;
        if (!option.choices.empty())
          choices += fmt::format("      {}:{}) choices=\"{}\" ;;\n", command.name, name,
                                 joined(option.choices));
      }
    }
    cases += fmt::format("    {})\n      options=\"{}\"\n      values=\"{}\"\n      ;;\n",
                         command.name, options.substr(1), values.empty() ? "" : values.substr(1));
  }
  std::string tail = kBashTail;
  tail.replace(tail.find("CHOICES"), std::string_view("CHOICES").size(), choices);
  return fmt::format(
      "{}  (( ${{#words[@]}} == 2 )) && choices=\"{}\"\n  case ${{words[1]}} in\n{}  esac\n{}",
      kBashHead, names, cases, tail);
}

std::string fish_completion(std::span<const CommandWords> commands) {
  std::string text = "# Completion of the edgecase command for fish.\n";
  for (const CommandWords& command : commands)
    text += fmt::format("complete -c edgecase -n __fish_use_subcommand -f -a {} -d {}\n",
                        command.name, quoted_for_fish(command.description));
  for (const CommandWords& command : commands)
    for (const OptionWords& option : command.options)
      if (!option.is_positional) text += fish_option(command, option);
  return text;
}

}  // namespace edgecase
