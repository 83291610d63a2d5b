// SPDX-License-Identifier: MIT
#include "tools/edgecase/output/html_report.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <set>

#include "diff/coverage/cause.h"
#include "model/renderer.h"
#include "model/text.h"
#include "reports/html.h"
#include "rules/all_rules.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

// The profiles of the renderers, from beside the cases, without those that cannot be read.
ReportProfiles profiles_of(const Results& results) {
  ReportProfiles told;
  if (results.cases.empty()) return told;
  Selection suite;
  suite.paths = {results.cases[0].file};
  for (const RendererInfo& info : results.renderers) {
    const auto found = load_profiles(suite, {known_as(info)});
    if (!found || found->empty()) continue;
    const Policy* policy = found->begin()->second.policy(info);
    if (policy == nullptr) continue;
    auto& places = told[info.name];
    places[""] = policy->rules;
    for (const auto& [surface, choices] : policy->surfaces) places[name_of(surface)] = choices;
  }
  return told;
}

// Reads the texts of case files. Cases of one file stand together.
class Sources {
 public:
  std::string operator()(const CaseResults& one) {
    if (one.file != file_) {
      file_ = one.file;
      text_.clear();
      std::error_code error;
      if (std::filesystem::is_regular_file(file_, error)) text_ = read_file(file_).value_or("");
      digest_ = digest_of_text(text_);
      if (!text_.empty() && digest_ != one.file_digest && complained_.insert(file_).second)
        print_error(
            fmt::format("{} is not what it was in the run; reports leave its text out", one.file));
    }
    return digest_ == one.file_digest ? text_ : "";
  }

 private:
  std::string file_;
  std::string text_;
  std::string digest_;
  std::set<std::string> complained_;  // files
};

ReportTexts texts_of(const Results& results, const std::optional<Comparison>& since) {
  ReportTexts texts;
  for (const Rule& rule : all_rules()) {
    texts.rules.push_back(
        {name_of(rule.id), rule.title, rule.spec, rule.latitude, rule.standard, {}});
    for (const Alternative& alternative : rule.alternatives)
      texts.rules.back().alternatives.emplace_back(alternative.name, alternative.meaning);
    for (const Ruling& ruling : rule.rulings) {
      texts.rulings.push_back({ruling.number, ruling.text, {}});
      for (RulingFact& fact : facts_of(ruling))
        texts.rulings.back().facts.emplace_back(std::move(fact.name), std::move(fact.text));
    }
  }
  texts.is_open_choice = is_open_choice;
  texts.profiles = profiles_of(results);
  texts.source_of = Sources();
  texts.since = since;
  return texts;
}

// Removes the scripts of an earlier page at `path` beyond the present `count`.
void remove_scripts(const std::filesystem::path& path, std::size_t count) {
  std::error_code error;
  for (std::size_t n = count + 1;; ++n) {
    const auto script = path.parent_path() / fmt::format("{}.{}.js", path.stem().string(), n);
    if (!std::filesystem::remove(script, error)) return;
  }
}

}  // namespace

std::vector<HtmlFile> make_html_report(const Results& results,
                                       const std::optional<Comparison>& since,
                                       const Generations& generations, const std::string& path,
                                       bool all_details) {
  ReportTexts texts = texts_of(results, since);
  texts.generations = generations;
  const bool has_scripts = all_details && path != "-";
  return html_files(results, texts, std::filesystem::path(path).filename().string(),
                    has_scripts ? Beyond::in_scripts : Beyond::left_out);
}

bool write_html_report(const std::vector<HtmlFile>& files, const std::string& path) {
  if (path == "-") {
    std::cout << files.front().text;
    return true;
  }
  const std::filesystem::path page = path;
  bool wrote = true;
  for (const HtmlFile& file : files)
    wrote = write_file(page.parent_path() / file.name, file.text) && wrote;
  remove_scripts(page, files.size() - 1);
  return wrote;
}

}  // namespace edgecase
