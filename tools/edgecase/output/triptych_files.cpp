// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/triptych_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "image/image_file.h"
#include "model/text.h"
#include "reports/triptych.h"
#include "tools/edgecase/options.h"
#include "tools/edgecase/output/whole_file.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOfName = 200;   // bytes; file systems take 255
constexpr std::size_t kMostOfPath = 1000;  // bytes; Linux takes 4095

// Replaces a colon, which Windows and GitHub's artifacts do not allow.
constexpr char kColon = '@';

// One part of a path, in which all but letters, digits and a few signs become "-".
std::string plain(std::string_view part) {
  std::string name(part.substr(0, kMostOfName));
  std::replace(name.begin(), name.end(), ':', kColon);
  std::replace_if(
      name.begin(), name.end(),
      [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte >= 0x7F ||
               std::string_view("/\\<>\"|?*").find(c) != std::string_view::npos;
      },
      '-');
  return name.find_first_not_of('.') == std::string::npos ? "-" : name;
}

// A renderer's folder, which no other renderer has.
std::string folder_of(const std::string& renderer, std::set<std::string>& taken) {
  std::string base = plain(renderer);
  std::replace_if(
      base.begin(), base.end(), [](char c) { return c == kColon || c == ' '; }, '-');
  std::string name = base;
  for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}-{}", base, n);
  return name;
}

// The error, empty on success.
std::string write_triptych(const Triptych& triptych, const fs::path& path) {
  if (std::string fault = fault_of_links(path); !fault.empty()) return fault;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) return fmt::format("cannot write {}: {}", path.string(), error.message());
  return write_png(path, {triptych.width, triptych.height, triptych.rgba}, triptych.scale);
}

}  // namespace

fs::path triptych_path(const std::string& id) {
  fs::path path;
  std::string_view rest = id;
  for (bool is_last = false; !is_last;) {
    const std::size_t slash = rest.find('/');
    is_last = slash == std::string_view::npos;
    path /= plain(rest.substr(0, slash));
    if (!is_last) rest.remove_prefix(slash + 1);
  }
  if (path.native().size() > kMostOfPath) path = "-";
  std::string plain_id = id;
  std::replace(plain_id.begin(), plain_id.end(), ':', kColon);
  const bool is_told = path.string() == plain_id && id.find(kColon) == std::string::npos;
  if (!is_told) path += "-" + digest_of_text(id);
  return path += ".png";
}

bool write_triptychs(const Results& results, const fs::path& folder) {
  std::size_t count = 0;
  std::set<std::string> taken;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const fs::path of_renderer = folder / folder_of(results.renderers[r].name, taken);
    for (const CaseResults& one : results.cases) {
      const auto triptych =
          r < one.results.size() ? triptych_of(one, one.results[r]) : std::nullopt;
      if (!triptych) continue;
      const std::string error = write_triptych(*triptych, of_renderer / triptych_path(one.id));
      if (!error.empty()) {
        print_error(error);
        return false;
      }
      ++count;
    }
  }
  print_error(fmt::format("{} triptych{} in {}", count, count == 1 ? "" : "s", folder.string()));
  return true;
}

}  // namespace edgecase
