// SPDX-License-Identifier: MIT
#include "reports/report_data.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

#include "base/threads.h"
#include "model/text.h"
#include "reports/base64.h"
#include "reports/case_details.h"
#include "reports/report_index.h"
#include "results/case_results_json.h"
#include "results/deflate.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

// Bytes of a block before deflation; one block is inflated to open a case.
constexpr std::size_t kBlock = 32 * 1024;

// Bytes of names and messages that are not UTF-8 are replaced.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// In JSON `<` occurs only in strings, so escaping it everywhere changes no value.
std::string escape_markup(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (char c : json) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

// Collects lines into blocks of about `most` bytes together. Further lines are numbered as if in
// one more block, but left out.
class Blocks {
 public:
  explicit Blocks(std::size_t most) : most_(most) {}

  // Any thread may ask. Once full, it stays so.
  bool is_full() const { return bytes_ >= most_; }
  // Returns the line's number.
  long add(const std::string& line) {
    if (is_full()) return leave_out();
    if (!text_.empty() && text_.size() + line.size() > kBlock) close();
    if (text_.empty()) first_lines_.push_back(lines_);
    text_ += line;
    text_ += '\n';
    return lines_++;
  }
  // The collected blocks; nothing can be added afterwards.
  std::vector<std::string> take() {
    if (!text_.empty()) close();
    return std::move(blocks_);
  }
  const std::vector<long>& first_lines() const { return first_lines_; }

 private:
  long leave_out() {
    if (!is_left_out_) first_lines_.push_back(lines_);
    is_left_out_ = true;
    return lines_++;
  }

  void close() {
    blocks_.push_back(to_base64(deflated(text_)));
    bytes_ += blocks_.back().size();
    text_.clear();
  }

  const std::size_t most_;
  std::string text_;
  long lines_ = 0;
  std::atomic<std::size_t> bytes_ = 0;  // of blocks
  bool is_left_out_ = false;
  std::vector<long> first_lines_;
  std::vector<std::string> blocks_;
};

// Indices of the cases with details: unexpected ones first, then the worst, then in their order.
std::vector<std::size_t> worth_a_look(const Results& results) {
  std::vector<std::size_t> order(results.cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !has_details(results.cases.outline(i)); });
  const auto worth = [&](std::size_t i) {
    bool unexpected = false;
    Verdict worst = Verdict::agree;
    for (const ResultOutline& answer : results.cases.outline(i).answers) {
      unexpected = unexpected || is_unexpected(answer.standing);
      if (answer.verdict != Verdict::not_run) worst = std::max(worst, answer.verdict);
    }
    return std::pair(unexpected, worst);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return worth(a) > worth(b); });
  return order;
}

Json generations_json(const Generations& generations) {
  Json list = Json::array();
  for (const auto& [name, driver] : generations) {
    Json one = {{"driver", name}, {"releases", Json::array()}, {"rows", Json::array()}};
    for (const Release& release : driver.releases) one["releases"].push_back(text_of(release));
    for (const GenerationRow& row : rows_of(driver))
      one["rows"].push_back({{"name", row.name},
                             {"cases", row.cases},
                             {"seen", row.seen},
                             {"reason", row.reason},
                             {"smallest", row.smallest}});
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

ReportData report_data(const Results& results, const ReportTexts& texts, std::size_t most) {
  const CaseHeads heads = heads_of(results);
  DetailLines lines;
  lines.of_case.assign(results.cases.size(), -1);
  lines.of_head.assign(heads.list.size(), -1);
  Blocks blocks(most);
  // A head without a text is asked once.
  std::vector<bool> is_asked(heads.list.size());
  const auto add_source = [&](std::size_t head) {
    if (is_asked[head]) return;
    is_asked[head] = true;
    const std::string text = texts.source_of ? texts.source_of(heads.list[head]) : "";
    if (!text.empty()) lines.of_head[head] = blocks.add(dump(text));
  };
  const std::vector<std::size_t> order = worth_a_look(results);
  const auto details_of = [&](std::size_t i) {
    return blocks.is_full() ? std::string() : dump(case_details(results.cases[order[i]]));
  };
  make_in_order(order.size(), details_of, [&](std::size_t i, const std::string& details) {
    add_source(heads.of_case[order[i]]);
    lines.of_case[order[i]] = blocks.add(details);
  });
  for (std::size_t head = 0; head < heads.list.size(); ++head) add_source(head);

  ReportData data;
  data.blocks = blocks.take();
  Json index = report_index(results, texts, heads, lines);
  index["blocks"] = blocks.first_lines();
  if (!texts.generations.empty()) index["generations"] = generations_json(texts.generations);
  Digest digest;
  digest.add(dump(index));
  for (const std::string& block : data.blocks) digest.add(block);
  data.key = digest.text();
  index["key"] = data.key;
  data.index = escape_markup(dump(index));
  return data;
}

}  // namespace edgecase
