// SPDX-License-Identifier: MIT
#include "tools/edgecase/help/wrapped_formatter.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace edgecase {
namespace {

constexpr std::size_t kLeastWidth = 40;
constexpr std::size_t kMostWidth = 100;
constexpr std::size_t kUsualWidth = 80;

// The width of the terminal, or 0.
std::size_t terminal_columns() {
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

void append_line(std::string_view line, std::size_t width, std::size_t indent, std::size_t column,
                 std::string& out) {
  if (line.starts_with(' ')) {
    out += line;
    return;
  }
  bool is_first = true;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    if (!is_first && column + 1 + word.size() > width) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    is_first = false;
  }
}

// Sorted by name, since the order of pointers differs between runs.
std::set<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::set<std::string> names;
  for (const CLI::Option* option : options) names.insert(option->get_name());
  return names;
}

}  // namespace

std::size_t help_width() {
  std::size_t columns = terminal_columns();
  if (const char* said = std::getenv("COLUMNS"); columns == 0 && said != nullptr)
    columns = static_cast<std::size_t>(std::max(0L, std::strtol(said, nullptr, 10)));
  if (columns == 0) columns = kUsualWidth;
  return std::clamp(columns, kLeastWidth, kMostWidth);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string out;
  std::size_t column = indent;  // where the caller has written up to
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    append_line(text.substr(at, end - at), width, indent, column, out);
    if (end < text.size()) {
      out += '\n';
      if (end + 1 < text.size() && text[end + 1] != '\n') out += std::string(indent, ' ');
    }
    at = end + 1;
  }
  return out;
}

WrappedFormatter::WrappedFormatter(std::size_t width) : width_(width) {
  constexpr std::size_t kNames = 26;  // columns of the names of options
  column_width(std::min(kNames, width / 3));
}

std::string WrappedFormatter::make_description(const CLI::App* app) const {
  std::string text = app->get_description();
  if (!text.ends_with('.')) text += '.';
  return wrapped(text, width_, 0) + "\n";
}

std::string WrappedFormatter::make_footer(const CLI::App* app) const {
  const std::string footer = app->get_footer();
  return footer.empty() ? "" : wrapped(footer, width_, 0) + "\n";
}

std::string WrappedFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

std::string WrappedFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  return entry(make_option_name(option, is_positional) + make_option_opts(option),
               make_option_desc(option));
}

std::string WrappedFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return "";
  // "INT:INT in [1 - 256]" and "TEXT:{auto,never}" are types with their validators.
  const std::string type = option->get_type_name();
  const bool is_repeatable = option->get_expected_max() == CLI::detail::expected_max_vector_size;
  return " " + type.substr(0, type.find(':')) + (is_repeatable ? " ..." : "");
}

std::string WrappedFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  const std::string type = option->get_type_name();
  if (const auto range = type.find('['); range != std::string::npos)
    text += "; " + type.substr(range + 1, type.find(']') - range - 1);
  if (const auto list = type.find('{'); list != std::string::npos)
    text +=
        " [" +
        CLI::detail::find_and_replace(type.substr(list + 1, type.find('}') - list - 1), ",", ", ") +
        "]";
  if (!option->get_default_str().empty())
    text += fmt::format(" (default: {})", option->get_default_str());
  if (option->get_required()) text += " (required)";
  for (const std::string& name : names_of(option->get_needs())) text += "; needs " + name;
  for (const std::string& name : names_of(option->get_excludes())) text += "; not with " + name;
  return text;
}

std::string WrappedFormatter::entry(const std::string& name, const std::string& description) const {
  const std::size_t column = get_column_width();
  std::string text = "  " + name;
  if (description.empty()) return text + "\n";
  // The name and its description are separated by at least a space.
  if (text.size() + 1 > column)
    text += '\n' + std::string(column, ' ');
  else
    text += std::string(column - text.size(), ' ');
  return text + wrapped(description, width_, column) + "\n";
}

}  // namespace edgecase
