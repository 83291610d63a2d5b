// SPDX-License-Identifier: MIT
#include "tools/edgecase/bench/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "model/text.h"
#include "reports/text.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

using nlohmann::ordered_json;

constexpr const char* kLine = "  {:<32} {:>12} {:>12}  {}\n";

std::string spread_words(const Spread& spread, const char* unit) {
  return fmt::format("{:.2f}{} ({:.2f} to {:.2f})", spread.median, unit, spread.low, spread.high);
}

// "12.3 M/s"
std::string rate_of(double rate) {
  if (rate >= 1e9) return fmt::format("{:.2f} G/s", rate / 1e9);
  if (rate >= 1e6) return fmt::format("{:.2f} M/s", rate / 1e6);
  if (rate >= 1e3) return fmt::format("{:.2f} k/s", rate / 1e3);
  return fmt::format("{:.2f} /s", rate);
}

void print_scene(const SceneTimes& scene) {
  const double exact = scene.items / spread_of(scene.exact).median;
  fmt::print("{} ({} {:.0f} a frame, {}x{})\n", scene.name, scene.unit, scene.items, scene.side,
             scene.side);
  for (const RendererTimes& one : scene.renderers) {
    if (!one.problem.empty()) {
      fmt::print(kLine, one.renderer, "-", rate_of(exact), one_line(one.problem));
      continue;
    }
    const auto pixels = static_cast<std::size_t>(scene.side) * static_cast<std::size_t>(scene.side);
    fmt::print(
        kLine, one.renderer, rate_of(scene.items / spread_of(one.seconds).median), rate_of(exact),
        fmt::format("{}, {} pixels differ", spread_words(ratio_of(one.seconds, scene.exact), "x"),
                    pixels - one.same_pixels));
  }
}

void print_pipeline(const PipelineRates& rates) {
  if (!rates.problem.empty()) {
    fmt::print("  {}: {}\n", rates.renderer, one_line(rates.problem));
    return;
  }
  const auto print = [](const char* name, const std::vector<double>& values,
                        const std::string& ratio) {
    fmt::print(kLine, name, rate_of(spread_of(values).median), "", ratio);
  };
  fmt::print("  {}, {}\n", rates.renderer, counted(rates.cases, "case", "cases"));
  print("  the worker alone", rates.worker, "");
  const auto to_worker = [&](const std::vector<double>& values) {
    return spread_words(ratio_of(values, rates.worker), "x") + " of the worker alone";
  };
  print("  run, one core", rates.one_core, to_worker(rates.one_core));
  print("  run, one job", rates.one_job, to_worker(rates.one_job));
  print("  run, two jobs", rates.two_jobs,
        fmt::format("{}, {} of one core", to_worker(rates.two_jobs),
                    spread_words(ratio_of(rates.two_jobs, rates.one_core), "x")));
  print("  fuzz, one job", rates.fuzzed, "");
}

void print_diff(const DiffRates& diff) {
  fmt::print("pictures of 4096x4096 RGBA8\n");
  fmt::print(kLine, "memcmp", rate_of(spread_of(diff.memcmp).median), "", "");
  fmt::print(kLine, "identical", rate_of(spread_of(diff.identical).median), "",
             spread_words(ratio_of(diff.identical, diff.memcmp), "x") + " of memcmp");
  fmt::print(kLine, "different everywhere", rate_of(spread_of(diff.different).median), "",
             spread_words(ratio_of(diff.different, diff.memcmp), "x") + " of memcmp");
}

void print_stages(const StageTimes& times) {
  double whole = 0;
  for (const StageTimes::Stage& stage : times.stages) whole += stage.seconds;
  fmt::print("where time goes: {}, {}, one thread\n", times.renderer,
             counted(times.cases, "case", "cases"));
  for (const StageTimes::Stage& stage : times.stages)
    fmt::print(kLine, stage.name,
               fmt::format("{:.1f} us", 1e6 * stage.seconds / static_cast<double>(times.cases)),
               fmt::format("{:.1f} %", 100 * stage.seconds / whole), "");
  fmt::print("  {:<20} {:>8} {:>12} {:>12} {:>12}\n", "a case, by subject", "cases", "worker",
             "exact", "compare");
  for (const StageTimes::Subject& subject : times.subjects) {
    const auto us = [&](double seconds) {
      return fmt::format("{:.1f} us", 1e6 * seconds / static_cast<double>(subject.cases));
    };
    fmt::print("  {:<20} {:>8} {:>12} {:>12} {:>12}\n", subject.name, subject.cases,
               us(subject.worker), us(subject.exact), us(subject.comparing));
  }
}

ordered_json json_of(const Spread& spread) {
  return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}};
}

ordered_json json_of(const SceneTimes& scene) {
  ordered_json renderers = ordered_json::object();
  for (const RendererTimes& one : scene.renderers) {
    if (!one.problem.empty()) {
      renderers[one.renderer] = {{"problem", one.problem}};
      continue;
    }
    renderers[one.renderer] = {{"seconds", json_of(spread_of(one.seconds))},
                               {"ratio", json_of(ratio_of(one.seconds, scene.exact))},
                               {"same_pixels", one.same_pixels}};
  }
  return {{"name", scene.name},
          {"side", scene.side},
          {"unit", scene.unit},
          {"items", scene.items},
          {"exact", {{"seconds", json_of(spread_of(scene.exact))}}},
          {"renderers", renderers}};
}

ordered_json json_of(const PipelineRates& rates) {
  if (!rates.problem.empty()) return {{"renderer", rates.renderer}, {"problem", rates.problem}};
  return {{"renderer", rates.renderer},
          {"cases", rates.cases},
          {"worker", json_of(spread_of(rates.worker))},
          {"one_core", json_of(spread_of(rates.one_core))},
          {"one_job", json_of(spread_of(rates.one_job))},
          {"two_jobs", json_of(spread_of(rates.two_jobs))},
          {"fuzz", json_of(spread_of(rates.fuzzed))},
          {"one_job_to_worker", json_of(ratio_of(rates.one_job, rates.worker))},
          {"two_jobs_to_worker", json_of(ratio_of(rates.two_jobs, rates.worker))},
          {"two_jobs_to_one", json_of(ratio_of(rates.two_jobs, rates.one_job))},
          {"two_jobs_to_one_core", json_of(ratio_of(rates.two_jobs, rates.one_core))}};
}

ordered_json json_of(const DiffRates& diff) {
  return {{"memcmp", json_of(spread_of(diff.memcmp))},
          {"identical", json_of(spread_of(diff.identical))},
          {"different", json_of(spread_of(diff.different))},
          {"identical_to_memcmp", json_of(ratio_of(diff.identical, diff.memcmp))},
          {"different_to_memcmp", json_of(ratio_of(diff.different, diff.memcmp))}};
}

ordered_json json_of(const StageTimes& times) {
  ordered_json stages = ordered_json::object();
  const auto us_a_case = [](double seconds, std::size_t cases) {
    return 1e6 * seconds / static_cast<double>(cases);
  };
  for (const StageTimes::Stage& stage : times.stages)
    stages[stage.name] = us_a_case(stage.seconds, times.cases);
  ordered_json subjects = ordered_json::array();
  for (const StageTimes::Subject& one : times.subjects)
    subjects.push_back({{"name", one.name},
                        {"cases", one.cases},
                        {"us_a_case",
                         {{"worker", us_a_case(one.worker, one.cases)},
                          {"exact", us_a_case(one.exact, one.cases)},
                          {"compare", us_a_case(one.comparing, one.cases)}}}});
  return {{"renderer", times.renderer},
          {"cases", times.cases},
          {"us_a_case", stages},
          {"subjects", subjects}};
}

template <class Item>
ordered_json json_of(const std::vector<Item>& items) {
  ordered_json list = ordered_json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

}  // namespace

void print_bench(const BenchReport& report) {
  if (!report.scenes.empty()) fmt::print(kLine, "", "renderer", "exact", "exact is faster by");
  for (const SceneTimes& scene : report.scenes) print_scene(scene);
  if (!report.pipelines.empty()) fmt::print("cases of 64x64 from a sweep\n");
  for (const PipelineRates& rates : report.pipelines) print_pipeline(rates);
  if (report.diff) print_diff(*report.diff);
  for (const StageTimes& times : report.stages) print_stages(times);
}

std::string bench_json(const BenchReport& report) {
  ordered_json document = {{"tool", kToolName}, {"rounds", report.rounds}};
  document["scenes"] = json_of(report.scenes);
  document["pipelines"] = json_of(report.pipelines);
  if (report.diff) document["diff"] = json_of(*report.diff);
  document["stages"] = json_of(report.stages);
  return document.dump(1) + "\n";
}

}  // namespace edgecase
