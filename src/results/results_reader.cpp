// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/threads.h"
#include "results/case_results_json.h"
#include "results/packed_text.h"
#include "results/results_json.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// With a sentence that says all that there is to say.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class Item, class Convert>
std::vector<Item> to_list(const ReadJson& json, Convert convert) {
  if (!json.is_array()) throw std::runtime_error("a list is missing");
  std::vector<Item> result;
  for (const ReadJson& item : json) result.push_back(convert(item));
  return result;
}

FaultSeen to_fault(const ReadJson& json) {
  FaultSeen seen{json.at("renderer"),
                 json.at("id"),
                 json.at("reason"),
                 json.at("link"),
                 json.at("cases"),
                 std::nullopt,
                 to_named<FaultState>(json.at("state"))};
  if (json.contains("before")) seen.before = json.at("before").get<std::size_t>();
  return seen;
}

RendererInfo to_renderer(const ReadJson& json) {
  RendererInfo info;
  info.name = json.at("name");
  info.vendor = json.at("vendor");
  info.version = json.at("version");
  info.device = json.at("device");
  info.subpixel_bits = WholeNumber(json.at("subpixel_bits"));
  info.traits = json.at("traits").get<std::map<std::string, std::string>>();
  return info;
}

ShareOfRun to_shard(const ReadJson& json) {
  const int number = WholeNumber(json.at("index"));
  const int count = WholeNumber(json.at("count"));
  if (number < 1 || number > count || count > kMostShards)
    throw std::runtime_error(fmt::format("there is no share {} of {}", number, count));
  return {number - 1, count, WholeNumber(json.at("cases")), json.at("selection"),
          json.contains("faulty") ? WholeNumber(json.at("faulty")) : std::size_t{0}};
}

Diagnostic to_diagnostic(const ReadJson& json) {
  return {json.at("file"), WholeNumber(json.at("line")), json.at("pointer"), json.at("message"),
          json.at("remedy")};
}

RuleAnswers to_rule_answers(const ReadJson& json) {
  const Rule* const rule = find_rule(json.at("rule").get<std::string>());
  if (rule == nullptr || rule->alternatives.empty())
    throw std::runtime_error("answers are counted for a rule that the catalogue does not have");
  RuleAnswers answers{rule->id, WholeNumber(json.at("asked")), {}};
  const ReadJson& counts = json.at("for");
  for (const Alternative& alternative : rule->alternatives) {
    std::size_t speaking = 0;
    if (counts.contains(alternative.name.c_str()))
      speaking = WholeNumber(counts.at(alternative.name.c_str()));
    if (speaking > answers.asked)
      throw std::runtime_error("more answers speak for an alternative than were asked");
    answers.against.push_back(answers.asked - speaking);
  }
  return answers;
}

// What is known before the first case.
void read_header(const ReadJson& json, Results& results) {
  const int format = WholeNumber(json.at("edgecase_results"));
  if (format != kResultsFormat)
    throw Refusal(fmt::format(
        "these are results of format {}, and this version reads format {}; read them with the "
        "version that wrote them, or run once more",
        format, kResultsFormat));
  results.tool = json.at("tool");
  results.policy = json.at("policy");
  results.latitude = to_named<Latitude>(json.at("latitude"));
  results.policy_digest = json.at("policy_digest");
  results.whole_suite = json.at("whole_suite");
  if (json.contains("shard")) results.shard = to_shard(json.at("shard"));
  const ReadJson& renderers = json.at("renderers");
  if (renderers.size() > kMostRenderers)
    throw std::runtime_error(
        fmt::format("it holds the answers of {} renderers, and a run may have "
                    "{}",
                    renderers.size(), kMostRenderers));
  results.renderers = to_list<RendererInfo>(renderers, to_renderer);
}

// What is known behind the last case.
void read_end(const ReadJson& json, Results& results) {
  const std::size_t cases = WholeNumber(json.at("cases"));
  if (cases != results.cases.size())
    throw std::runtime_error(
        fmt::format("it holds {} cases instead of {}", results.cases.size(), cases));
  results.interrupted = json.at("interrupted");
  if (json.contains("left_out")) results.left_out = WholeNumber(json.at("left_out"));
  results.diagnostics = to_list<Diagnostic>(json.at("diagnostics"), to_diagnostic);
  results.faults = to_list<FaultSeen>(json.at("faults"), to_fault);
  const auto each_surface = [&](const char* member, const auto& read) {
    if (!json.contains(member)) return;
    for (const auto& [renderer, surfaces] : json.at(member).items())
      for (const auto& [surface, value] : surfaces.items())
        read(std::string(renderer), std::string(surface), value);
  };
  each_surface("refuted", [&](const auto& renderer, const auto& surface, const ReadJson& text) {
    results.refuted[renderer][surface] = to_refuted(text);
  });
  each_surface("rules", [&](const auto& renderer, const auto& surface, const ReadJson& list) {
    results.rules[renderer][surface] = to_list<RuleAnswers>(list, to_rule_answers);
  });
}

// Lines that are about cases, to be parsed by a thread of their own.
struct Batch {
  std::vector<std::pair<std::size_t, std::string>> lines;  // with their numbers, from 1
  std::size_t bytes = 0;
  std::shared_ptr<const HeadsRead> heads;
};

// The cases of a batch, up to the first line that is at fault.
struct Parsed {
  std::vector<ShelvedCase> cases;
  std::string fault;     // with its place; empty: none
  std::size_t line = 0;  // that is at fault
  bool is_whole = true;  // is that line JSON?
};

Parsed parsed(const Batch& batch, const std::vector<RendererInfo>& renderers,
              const std::shared_ptr<Shelf>& shelf) {
  Parsed result;
  for (const auto& [number, line] : batch.lines) {
    std::string where = fmt::format("line {}: ", number);
    try {
      const ReadJson json = parse_line(line);
      where = fmt::format("case {}: ", json.at("case").get<std::string>());
      result.cases.emplace_back(to_case(json, *batch.heads, renderers), shelf);
    } catch (const std::exception& error) {
      result.fault = where + fault_of(error);
      result.line = number;
      result.is_whole = dynamic_cast<const ReadJson::parse_error*>(&error) == nullptr;
      return result;
    }
  }
  return result;
}

// Reads line by line. Cases are parsed on all processors, and come in their order.
class Reading {
 public:
  Reading(std::istream& in, Cut cut) : lines_(in), cut_(cut) {}

  std::variant<Results, std::string> operator()() {
    try {
      read();
      return std::move(results_);
    } catch (const Refusal& refusal) {
      return refusal.what();
    } catch (const std::exception& error) {
      return fmt::format(
          "this is no results file of `edgecase run`: {}{}; name a file that `edgecase run --json` "
          "wrote",
          where_, fault_of(error));
    }
  }

 private:
  void read() {
    if (!next()) throw std::runtime_error("it is empty");
    if (line_ == "{") refuse_object();
    read_header(parse_line(line_), results_);
    while (next()) {
      if (line_.starts_with("{\"case\"")) {
        add_case_line();
        continue;
      }
      const ReadJson json = other_line();
      if (json.is_discarded()) break;
      if (json.contains("end")) return finish(json);
      if (json.contains("edgecase_results"))
        read_header_again(json);
      else
        add_head(json);
    }
    take_all();
    end_early();
  }

  // The first format was one object over many lines; other files are, too.
  [[noreturn]] void refuse_object() {
    const bool is_first_format = next() && line_.starts_with("\"tool\":");
    where_ = "";
    if (!is_first_format) throw std::runtime_error("it is one object over many lines");
    throw Refusal(fmt::format(
        "these are results of format 1, and this version reads format {}; run once more to make "
        "them anew",
        kResultsFormat));
  }

  bool next() {
    where_ = fmt::format("line {}: ", ++number_);
    return lines_.next(line_);
  }

  // More is known of the renderers than before; they are the same ones. Threads read their names.
  void read_header_again(const ReadJson& json) {
    start_batch();
    while (!started_.empty()) take_first();
    std::vector<std::string> names;
    for (const RendererInfo& info : results_.renderers) names.push_back(info.name);
    read_header(json, results_);
    if (!std::ranges::equal(names, results_.renderers, {}, {}, &RendererInfo::name))
      throw std::runtime_error("the renderers are others than those of the first line");
  }

  // Discarded where the line is the last one and not whole.
  ReadJson other_line() {
    try {
      return parse_line(line_);
    } catch (const ReadJson::parse_error&) {
      std::string rest;
      if (lines_.next(rest)) throw;
      return ReadJson(ReadJson::value_t::discarded);
    }
  }

  void add_head(const ReadJson& json) {
    const std::size_t head = WholeNumber(json.at("head"));
    const std::size_t next = heads_.first + heads_.list.size();
    if (head != next)
      throw std::runtime_error(fmt::format("head {} stands in the place of {}", head, next));
    heads_.list.push_back(std::make_shared<const CaseResults>(to_head(json)));
  }

  void add_case_line() {
    constexpr std::size_t kMostBytes = std::size_t{1} << 18;
    batch_.bytes += line_.size();
    batch_.lines.emplace_back(number_, std::move(line_));
    if (batch_.bytes > kMostBytes) start_batch();
  }

  void start_batch() {
    if (batch_.lines.empty()) return;
    if (started_.is_full()) take_first();
    batch_.heads = std::make_shared<const HeadsRead>(heads_);
    started_.start([this, batch = std::exchange(batch_, {})] {
      return parsed(batch, results_.renderers, shelf_);
    });
    heads_.keep_last_file();
  }

  void take_first() {
    Parsed first = started_.take();
    for (ShelvedCase& one : first.cases) results_.cases.push_back(std::move(one));
    if (first.fault.empty()) return;
    where_ = "";
    // The last line of a file that is cut off.
    if (!first.is_whole && started_.empty() && first.line + 1 == number_ && is_at_end_) return;
    throw std::runtime_error(first.fault);
  }

  void take_all() {
    is_at_end_ = true;
    start_batch();
    while (!started_.empty()) take_first();
  }

  void finish(const ReadJson& json) {
    start_batch();
    while (!started_.empty()) take_first();
    read_end(json, results_);
    if (next()) throw std::runtime_error("something follows its end");
    if (lines_.is_cut()) end_early();
  }

  void end_early() {
    results_.interrupted = true;
    if (cut_ == Cut::kept) return;
    throw Refusal(
        fmt::format("the results end in their middle, behind {} cases; name a file that is whole, "
                    "or go on with "
                    "that run by `edgecase run --resume`",
                    results_.cases.size()));
  }

  LineReader lines_;
  Cut cut_;
  std::string line_;
  std::size_t number_ = 0;  // of the line, from 1
  std::string where_;       // for messages
  bool is_at_end_ = false;  // of a file without a last line
  HeadsRead heads_;
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  Batch batch_;
  Results results_;
  Ahead<Parsed> started_;
};

}  // namespace

std::variant<Results, std::string> read_results(std::istream& in, Cut cut) {
  return Reading(in, cut)();
}

std::variant<Results, std::string> read_results(const std::string& text, Cut cut) {
  std::istringstream in(text);
  return read_results(in, cut);
}

}  // namespace edgecase
