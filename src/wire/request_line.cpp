// SPDX-License-Identifier: MIT
#include "wire/request_line.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "model/fnv.h"
#include "wire/json_values.h"
#include "wire/scene_json.h"

namespace edgecase {

using nlohmann::json;
using wire::Path;
using wire::Refusal;

namespace {

// The value of "answer" in a request for coverage only.
constexpr std::string_view kCoverageAnswer = "coverage";

// The digest comes first, so that whatever else is wrong can be answered.
void read_request(const json& document, Request& request) {
  const Path root;
  request.digest = wire::read_string(wire::member(document, root, "digest"), {root, "digest"});
  wire::read_integer(wire::member(document, root, "edgecase"), {root, "edgecase"}, kProtocolVersion,
                     kProtocolVersion);
  request.id = wire::read_string(wire::member(document, root, "id"), {root, "id"});
  // Keys beside the scene never change the drawing, so unknown ones are ignored.
  const json* answer = wire::optional_member(document, "answer");
  request.coverage_only = answer != nullptr && *answer == kCoverageAnswer;
  request.scene = wire::read_scene(wire::member(document, root, "scene"), {root, "scene"});
  const std::string digest = digest_of(scene_json(request.scene));
  if (digest != request.digest)
    throw Refusal(fmt::format("/digest is \"{}\", but the scene's is \"{}\"",
                              wire::excerpt(request.digest, 40), digest));
}

}  // namespace

std::string scene_json(const Scene& scene) {
  fmt::memory_buffer text;
  wire::write_scene(text, scene);
  return fmt::to_string(text);
}

std::string digest_of(std::string_view scene_json) {
  return fmt::format("{:016x}", fnv_of(scene_json));
}

std::string request_line(const std::string& id, std::string_view scene_json, bool coverage_only) {
  const std::string quoted = json(id).dump(-1, ' ', true, json::error_handler_t::replace);
  const std::string answer =
      coverage_only ? fmt::format(R"("answer":"{}",)", kCoverageAnswer) : std::string();
  return fmt::format(R"({{"edgecase":{},"id":{},"digest":"{}",{}"scene":{}}})", kProtocolVersion,
                     quoted, digest_of(scene_json), answer, scene_json);
}

std::variant<Request, WireError> parse_request(std::string_view line) {
  Request request;
  try {
    read_request(wire::parse_text(line), request);
    return request;
  } catch (const Refusal& refusal) {
    return WireError{refusal.what(), request.digest};
  }
}

}  // namespace edgecase
