// SPDX-License-Identifier: MIT
#include "tools/edgecase/bench/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

using nlohmann::json;

// Entries of lists are known by these members.
std::string name_in_list(const json& entry) {
  for (const char* key : {"name", "renderer"})
    if (const auto found = entry.find(key); found != entry.end() && found->is_string())
      return found->get<std::string>();
  return "";
}

class Comparison {
 public:
  void walk(const json& here, const json& there, const std::string& path) {
    if (here.is_object() && there.is_object())
      walk_object(here, there, path);
    else if (here.is_array() && there.is_array())
      walk_list(here, there, path);
  }

  std::vector<ComparedFigure> take() { return std::move(figures_); }

 private:
  static std::string below(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + " / " + name;
  }

  void add(const std::string& path, const json& here, const json& there) {
    if (!here.is_number() || !there.is_number()) return;
    if (here.get<double>() > 0 && there.get<double>() > 0)
      figures_.push_back({path, here.get<double>(), there.get<double>()});
  }

  void walk_object(const json& here, const json& there, const std::string& path) {
    if (here.contains("median") && there.contains("median")) {
      add(path, here["median"], there["median"]);
      return;
    }
    for (const auto& [key, value] : here.items()) {
      const auto other = there.find(key);
      if (other == there.end()) continue;
      if (key == "us_a_case" && value.is_object() && other->is_object())
        for (const auto& [stage, time] : value.items())
          if (other->contains(stage)) add(below(path, stage), time, (*other)[stage]);
      if (key != "us_a_case") walk(value, *other, below(path, key));
    }
  }

  void walk_list(const json& here, const json& there, const std::string& path) {
    for (const json& one : here) {
      const std::string name = name_in_list(one);
      const auto other = std::ranges::find_if(
          there, [&](const json& entry) { return name_in_list(entry) == name; });
      if (!name.empty() && other != there.end()) walk(one, *other, below(path, name));
    }
  }

  std::vector<ComparedFigure> figures_;
};

}  // namespace

std::variant<std::vector<ComparedFigure>, std::string> compare_benches(const std::string& here,
                                                                       const std::string& there) {
  const json other = json::parse(there, nullptr, false);
  if (!other.is_object() || !other.contains("stages") || !other.contains("scenes"))
    return "it is no file that `edgecase bench --json` wrote";
  Comparison comparison;
  comparison.walk(json::parse(here), other, "");
  return comparison.take();
}

void print_comparison(const std::vector<ComparedFigure>& figures) {
  fmt::print("{:>12} {:>12} {:>8}\n", "here", "there", "ratio");
  for (const ComparedFigure& figure : figures)
    fmt::print("{:>12.4g} {:>12.4g} {:>7.2f}x  {}\n", figure.here, figure.there,
               figure.here / figure.there, figure.path);
  if (figures.empty()) fmt::print("nothing was measured in both\n");
}

}  // namespace edgecase
