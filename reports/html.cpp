// SPDX-License-Identifier: MIT
#include "reports/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/page.h"
#include "reports/report_data.h"

namespace edgecase {
namespace {

// Allows scripts that the page's own script adds.
constexpr const char* kMayLoad = " 'strict-dynamic'";

// The number of leading blocks with at most `most` bytes together.
std::size_t count_within(const std::vector<std::string>& blocks, std::size_t from,
                         std::size_t most) {
  std::size_t bytes = 0;
  std::size_t count = 0;
  while (from + count < blocks.size() && (bytes += blocks[from + count].size()) <= most) ++count;
  return count;
}

std::string chunk_text(const ReportData& data, std::size_t first, std::size_t count) {
  std::string text = fmt::format("edgecaseBlocks(\"{}\",{},[\n", data.key, first);
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("\"{}\",\n", data.blocks[first + i]);
  return text + "]);\n";
}

// Members of the index: the number of blocks in the page, and the names of chunks with their first
// blocks.
std::string places_of_blocks(std::size_t inlined,
                             const std::vector<std::pair<std::string, std::size_t>>& chunks) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [name, first] : chunks) list.push_back({{"name", name}, {"first", first}});
  return fmt::format("\"here\":{},\"chunks\":{}", inlined,
                     list.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

// Bytes of blocks for which a page has room.
std::size_t room_beside(const std::string& index, std::size_t max_inlined) {
  constexpr std::size_t kMarkup = 200'000;  // the viewer, and the markup around each block
  const std::size_t taken = index.size() + kMarkup;
  return taken < kMostOfPage ? std::min(max_inlined, kMostOfPage - taken) : 0;
}

}  // namespace

std::vector<HtmlFile> html_files(const Results& results, const ReportTexts& texts,
                                 const std::string& name, Beyond beyond, std::size_t max_inlined) {
  const ReportData data = beyond == Beyond::in_scripts ? report_data(results, texts)
                                                       : report_data(results, texts, max_inlined);
  const std::string stem = name.substr(0, name.rfind(".html"));
  std::vector<HtmlFile> files(1);
  std::vector<std::pair<std::string, std::size_t>> chunks;
  const std::size_t inlined = count_within(data.blocks, 0, room_beside(data.index, max_inlined));
  const std::size_t end = beyond == Beyond::in_scripts ? data.blocks.size() : inlined;
  for (std::size_t first = inlined; first < end;) {
    const std::size_t count = std::max(std::size_t{1}, count_within(data.blocks, first, kChunk));
    chunks.emplace_back(fmt::format("{}.{}.js", stem, chunks.size() + 1), first);
    files.push_back({chunks.back().first, chunk_text(data, first, count)});
    first += count;
  }
  std::string page{kPageBeforeLoads};
  if (!chunks.empty()) page += kMayLoad;
  page += kPageBeforeData;
  page += '{' + places_of_blocks(inlined, chunks) + ',' + data.index.substr(1);
  page += kPageBeforeBlocks;
  for (std::size_t i = 0; i < inlined; ++i)
    page +=
        fmt::format("<script type=\"text/plain\" id=\"block-{}\">{}</script>\n", i, data.blocks[i]);
  page += kPageAfterBlocks;
  files.front() = {name, std::move(page)};
  return files;
}

}  // namespace edgecase
