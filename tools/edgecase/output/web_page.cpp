// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/web_page.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/threads.h"
#include "raster/rasterizer.h"
#include "reports/base64.h"
#include "reports/page.h"
#include "results/deflate.h"
#include "tools/edgecase/options.h"
#include "wire/answer_line.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

using Json = nlohmann::json;

// Of a block: a browser inflates one at a time.
constexpr std::size_t kBlockWeight = std::size_t{1} << 20;

std::string text_of(const Json& value) {
  return value.dump(-1, ' ', true, Json::error_handler_t::replace);
}

// Inside an element no text may end it.
std::string page_of(const Json& data) {
  std::string text;
  for (const char c : text_of(data)) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  std::string page(kWebBeforeLoads);
  page += kWebBeforeData;
  page += text;
  page += kWebBeforeBlocks;
  page += kWebAfterBlocks;
  return page;
}

// Fragments by pixel, row by row from the bottom, as runs of equal numbers: number, length, ...
// Null where fragments are not those of pixels.
Json runs_of_hits(const Scene& scene, const ResolvedPolicy& policy) {
  if (scene.target.samples > 1 || !scene.supersampling.empty()) return nullptr;
  const Rendering exact = rasterize_for_comparison(scene, policy);
  std::vector<std::uint32_t> counts(exact.pixel_index(0, exact.height));
  for (const Fragment& fragment : exact.fragments)
    ++counts[exact.pixel_index(fragment.x, fragment.y)];
  Json runs = Json::array();
  for (std::size_t i = 0; i < counts.size();) {
    const auto end = std::find_if(counts.begin() + static_cast<std::ptrdiff_t>(i), counts.end(),
                                  [&](std::uint32_t count) { return count != counts[i]; });
    const auto length = static_cast<std::size_t>(end - counts.begin()) - i;
    runs.push_back(counts[i]);
    runs.push_back(length);
    i += length;
  }
  return runs;
}

// The line of a case: its id, digest, scene and hits.
std::string line_of(const Case& one, const ResolvedPolicy& policy) {
  const std::string scene = scene_json(one.scene);
  return "[" + text_of(one.id) + ",\"" + digest_of(scene) + "\"," + scene + "," +
         text_of(runs_of_hits(one.scene, policy)) + "]\n";
}

}  // namespace

std::string web_suite_page(const CaseStore& cases, const std::string& title) {
  const ResolvedPolicy policy{Policy()};
  const std::vector<CaseSlice> slices = cut_cases(cases, {kBlockWeight});
  Json blocks = Json::array();
  make_in_order(
      slices.size(),
      [&](std::size_t i) {
        std::string lines;
        for (std::size_t at = slices[i].begin; at < slices[i].end; ++at)
          lines += line_of(cases[at], policy);
        return to_base64(deflated(lines));
      },
      [&](std::size_t, std::string block) { blocks.push_back(std::move(block)); });
  return page_of({{"mode", "suite"},
                  {"tool", kToolName},
                  {"title", title},
                  {"count", cases.size()},
                  {"blocks", std::move(blocks)}});
}

std::string web_show_page(const Case& one) {
  const Rendering exact = rasterize(one.scene, ResolvedPolicy{Policy()});
  return page_of({{"mode", "show"},
                  {"title", one.title},
                  {"id", one.id},
                  {"scene", Json::parse(scene_json(one.scene))},
                  {"exact", Json::parse(answer_line("", exact, nullptr))}});
}

}  // namespace edgecase
