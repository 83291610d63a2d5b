// SPDX-License-Identifier: MIT
//
// Case: one scene with the words around it, as a case file gives them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/scene.h"
#include "model/storage.h"

namespace edgecase {

// The author's hand-drawn truth for the exact side under one policy.
struct Expect {
  std::string policy = "opengl";
  // Hits per pixel, row by row from the bottom, width * height of them; empty where
  // `masks` is drawn.
  std::vector<int> coverage;
  // Of one primitive on a multisampled target: which samples it covers, per pixel in the same
  // order, bit s for sample s.
  std::vector<std::uint32_t> masks;
  std::string where;  // FILE:LINE and JSON pointer of the drawing, for messages
};

struct Case {
  // Path from the suite's root, without suffix, with '/'; then ":" and each of `parts`.
  std::string id;
  // What tells the case from the others of its file: "dx=-0.5" of each axis of a sweep, in the
  // file's order, then "reverse", "winding", "octant=3" or "translate=3,2".
  std::vector<std::string> parts;
  std::string title;
  std::string why;
  std::vector<std::string> rules;  // ids of the rules that the case is about
  std::string spec;
  std::string origin;  // a link, where a bug led to the case
  std::vector<std::string> tags;
  std::filesystem::path file;
  SharedText source;  // the file's
  Scene scene;
  std::vector<Expect> expect;
};

// Something wrong with a file that a person wrote.
struct Diagnostic {
  std::string file;
  int line = 0;         // from 1; 0: the file as a whole
  std::string pointer;  // RFC 6901, "" for the document
  std::string message;  // what is wrong
  std::string remedy;   // how to put it right
};

// "FILE:LINE: POINTER: message; remedy", the parts that exist.
// A pointer through names of great length is cut.
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
