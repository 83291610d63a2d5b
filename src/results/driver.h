// SPDX-License-Identifier: MIT
//
// Drivers: who draws, and in which release, from what a renderer reports of itself.
//
// Known faults belong to a driver, however it is reached: llvmpipe has the same faults through
// OSMesa and through EGL. Of OpenGL, the driver is read from GL_RENDERER and its release from
// GL_VERSION. A program that is no OpenGL is its own driver, by its renderer's name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/renderer.h"

namespace edgecase {

struct Release {
  std::string product;       // "Mesa"; empty where the version begins with a number
  std::vector<int> numbers;  // 22, 3, 6; empty where no version is reported
  bool is_es = false;        // reached as OpenGL ES

  friend bool operator==(const Release&, const Release&) = default;
};

// "Mesa 22.3.6", "Mesa 22.3.6 ES", "1.0"; "unversioned" where nothing is reported.
std::string text_of(const Release& release);

// "4.5 (Core Profile) Mesa 22.3.6" is Mesa 22.3.6, "OpenGL ES 3.2 NVIDIA 535.104" is NVIDIA
// 535.104 of OpenGL ES, "tiny 1.2" is tiny 1.2.
Release release_of(const RendererInfo& info);

// "llvmpipe", "softpipe", "zink" (on Mesa's own Vulkan), "SwiftShader" (zink on SwiftShader); of
// another OpenGL, GL_RENDERER up to its first bracket or slash; else known_as(info).
std::string driver_of(const RendererInfo& info);

// The releases of one product from `low` on and before `high`, where either is given:
// "Mesa >=22.3 <25.1". OpenGL and OpenGL ES are not told apart.
struct VersionRange {
  std::string product;
  std::vector<int> low;   // empty: from the first on
  std::vector<int> high;  // empty: without end

  friend bool operator==(const VersionRange&, const VersionRange&) = default;
};

std::string text_of(const VersionRange& range);
// A sentence that says what is wrong, otherwise.
std::variant<VersionRange, std::string> parse_range(const std::string& text);

bool holds(const VersionRange& range, const Release& release);

// Is version `a` before `b`? Numbers that are not given count as 0.
bool is_before(const std::vector<int>& a, const std::vector<int>& b);

}  // namespace edgecase
