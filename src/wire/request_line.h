// SPDX-License-Identifier: MIT
//
// The line that requests a rendering from another process: a scene as JSON, reference/PROTOCOL.md.
//
// Our own OpenGL workers and any program behind `exec:` get the same line. Coordinates are
// multiples of 2^-16 and colours float32 values; both are exact as doubles, and numbers are printed
// with enough digits to read back as the same double, so nothing is lost on the way.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "model/scene.h"

namespace edgecase {

// Why a line is refused: one sentence with the fault and its place, without a full stop.
struct WireError {
  std::string message;
  std::string digest = {};  // of a refused request, whose refusal repeats it; empty if unknown
};

// Version of the protocol, the value of "edgecase" in every request.
constexpr int kProtocolVersion = 1;

// Longest line in either direction, in bytes: room for a 4096 x 4096 target with all its numbers.
constexpr std::size_t kMaxLineLength = std::size_t{1} << 30;

struct Request {
  std::string id;      // of the case, for messages
  std::string digest;  // of the scene; repeated in the answer
  Scene scene;
  bool coverage_only = false;  // the answer may omit pixels, depths and colours
};

// A scene as one JSON object without line breaks: the value of "scene" in a request.
std::string scene_json(const Scene& scene);

// 16 hexadecimal digits: 64-bit FNV-1a over the bytes of scene_json. An answer repeats it, which
// shows to which scene it belongs.
std::string digest_of(std::string_view scene_json);

// The whole request, without a line break at its end.
std::string request_line(const std::string& id, std::string_view scene_json,
                         bool coverage_only = false);

// The inverse. Refuses anything but a request of this version, unknown keys and names of the scene,
// scenes beyond the limits in model/scene.h, and a scene that does not match the line's digest.
std::variant<Request, WireError> parse_request(std::string_view line);

}  // namespace edgecase
