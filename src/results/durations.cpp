// SPDX-License-Identifier: MIT
#include "results/durations.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "results/json_writer.h"
#include "results/packed_text.h"
#include "results/shallow_json.h"

namespace edgecase {
namespace {

double to_seconds(const ReadJson& json) {
  const double seconds = json.get<double>();
  if (!std::isfinite(seconds) || seconds < 0)
    throw std::runtime_error(fmt::format("{} is no number of seconds", seconds));
  return seconds;
}

void add_line(const std::string& line, Durations& durations) {
  const ReadJson json = parse_line(line);
  auto& of_case = durations[json.at("case").get<std::string>()];
  if (!json.at("seconds").is_object()) throw std::runtime_error("\"seconds\" is no object");
  for (const auto& [renderer, seconds] : json.at("seconds").items())
    of_case[std::string(renderer)] = to_seconds(seconds);
}

}  // namespace

void write_durations(const Durations& durations, std::ostream& out) {
  for (const auto& of_case : durations) {
    std::string text;
    JsonWriter json(text);
    json.object([&] {
      json.member("case", of_case.first);
      json.key("seconds").object([&] {
        // Microseconds: less is noise.
        for (const auto& [renderer, seconds] : of_case.second)
          json.member(renderer, std::round(seconds * 1e6) / 1e6);
      });
    });
    out << text << '\n';
  }
}

std::variant<Durations, std::string> read_durations(std::istream& in) {
  Durations durations;
  LineReader lines(in);
  std::size_t number = 0;
  try {
    for (std::string line; lines.next(line);) {
      ++number;
      add_line(line, durations);
    }
  } catch (const std::exception& error) {
    return fmt::format(
        "these are no durations: line {}: {}; name a file that `edgecase run --timings` wrote",
        number, fault_of(error));
  }
  return durations;
}

double seconds_of(const Durations& durations, const std::string& id, const std::string& renderer) {
  const auto of_case = durations.find(id);
  if (of_case == durations.end()) return 0;
  const auto found = of_case->second.find(renderer);
  return found != of_case->second.end() ? found->second : 0;
}

}  // namespace edgecase
