// SPDX-License-Identifier: MIT
//
// Case: one scene with its title, reasons and expectations, as read from a case file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/shared.h"
#include "model/scene.h"

namespace edgecase {

// The author's hand-drawn coverage for exact under one policy.
struct Expect {
  std::string policy = "opengl";
  // Hits per pixel, row by row from the bottom, width * height numbers; empty if `masks` is drawn.
  std::vector<int> coverage;
  // For one primitive on a multisampled target: the samples that it covers, per pixel in the same
  // order, with bit s for sample s.
  std::vector<std::uint32_t> masks;
  std::string where;  // FILE:LINE and JSON pointer of the drawing, for messages
};

struct Case {
  // Path below the suite's root, with '/' and without suffix; then ":" and each of `parts`.
  std::string id;
  // What distinguishes the case within its file: "dx=-0.5" for each axis of a sweep, in the file's
  // order, then "reverse", "winding", "octant=3" or "translate=3,2".
  std::vector<std::string> parts;
  std::string title;
  std::string why;
  std::vector<std::string> rules;  // ids of the rules that the case tests
  std::string spec;
  std::string origin;  // a link to the bug that led to the case, if there is one
  std::vector<std::string> tags;
  std::filesystem::path file;
  SharedText source;  // the text of `file`
  // Its images are drawn, too, and held against it (diff/invariance.h).
  bool invariant = false;
  Scene scene;
  std::vector<Expect> expect;
};

// A mistake in a file that a person wrote.
struct Diagnostic {
  std::string file;
  int line = 0;         // from 1; 0 for the file as a whole
  std::string pointer;  // RFC 6901, "" for the document
  std::string message;  // the mistake
  std::string remedy;   // how to correct it
};

// "FILE:LINE: POINTER: message; remedy", without the parts that are empty. A very long pointer is
// cut.
inline std::string to_string(const Diagnostic& diagnostic) {
  constexpr std::size_t kMostOfPointer = 200;  // bytes
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) text += ":" + std::to_string(diagnostic.line);
  text += ": ";
  if (diagnostic.pointer.size() > kMostOfPointer)
    text += diagnostic.pointer.substr(0, kMostOfPointer) + "...: ";
  else if (!diagnostic.pointer.empty())
    text += diagnostic.pointer + ": ";
  text += diagnostic.message;
  if (!diagnostic.remedy.empty()) text += "; " + diagnostic.remedy;
  return text;
}

}  // namespace edgecase
