// SPDX-License-Identifier: MIT
#include "recording/stored_outcome.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

#include "wire/answer_line.h"

namespace edgecase::recording {

namespace {

using nlohmann::json;

// What failures begin with, and answers do not.
constexpr const char* kFailureStart = "{\"failure\":";

FailureKind kind_of_name(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(FailureKind::unavailable); ++i)
    if (name == name_of(static_cast<FailureKind>(i))) return static_cast<FailureKind>(i);
  throw std::runtime_error("the kind of failure \"" + name + "\" is not known");
}

Failure unreadable(const std::string& why) {
  return {FailureKind::garbage, "what was recorded is refused: " + why};
}

Failure read_failure(const std::string& line) {
  try {
    const json failure = json::parse(line);
    return {kind_of_name(failure.at("failure")), failure.at("reason")};
  } catch (const std::exception& error) {
    return unreadable(error.what());
  }
}

}  // namespace

std::string stored_line(const Outcome& outcome) {
  if (const auto* rendering = std::get_if<Rendering>(&outcome))
    return answer_line("", *rendering, nullptr);
  const Failure& failure = std::get<Failure>(outcome);
  const json line = {{"failure", name_of(failure.kind)}, {"reason", failure.reason}};
  return line.dump(-1, ' ', true, json::error_handler_t::replace);
}

Outcome outcome_of(const std::string& line, const Scene& scene) {
  if (line.starts_with(kFailureStart)) return read_failure(line);
  auto parsed = parse_answer(line, "", scene);
  if (auto* answer = std::get_if<Answer>(&parsed)) return std::move(answer->outcome);
  return unreadable(std::get<WireError>(parsed).message);
}

}  // namespace edgecase::recording
