// SPDX-License-Identifier: MIT
//
// The line that asks another process for a rendering: a scene as JSON, reference/PROTOCOL.md.
//
// Our own OpenGL workers and any program behind `exec:` get the same line. Coordinates are
// multiples of 2^-16 and colours float32 values; both are exact as doubles, and JSON numbers are
// printed with as many digits as bring the same double back, so nothing is lost on the way.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "model/scene.h"

namespace edgecase {

// Why a line is refused: one sentence that says what is wrong and where, no full stop at its end.
struct WireError {
  std::string message;
};

// Version of the protocol, the value of "edgecase" in every request.
constexpr int kProtocolVersion = 1;

// Longest line in either direction, in bytes: room for a 4096 x 4096 target with all its numbers.
constexpr std::size_t kMaxLineLength = std::size_t{1} << 30;

struct Request {
  std::string id;      // of the case, for messages
  std::string digest;  // of the scene, to be repeated in the answer
  Scene scene;
  bool coverage_only = false;  // pixels, depths and colours may be left out of the answer
};

// A scene as one JSON object without line breaks: the value of "scene" in a request.
std::string scene_json(const Scene& scene);

// 16 hexadecimal digits: 64-bit FNV-1a over the bytes of scene_json. An answer repeats it, which
// tells an answer to this scene from one to another.
std::string digest_of(std::string_view scene_json);

// The whole request, without the line break at its end.
std::string request_line(const std::string& id, std::string_view scene_json,
                         bool coverage_only = false);

// The inverse. Refuses what is no request of this version, what lies outside the limits that
// model/scene.h states, and a scene that does not have the digest that the line gives it.
std::variant<Request, WireError> parse_request(std::string_view line);

}  // namespace edgecase
