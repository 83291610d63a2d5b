// SPDX-License-Identifier: MIT
//
// Checks the text of an OBJ file before a library reads it.
//
// The library takes a word that is no number for 0, leaves out faces that it does not understand,
// and trusts indices. So every line is judged here first, and what is handed on are its vertices
// texture coordinates and faces alone. What the format has beside (normals, names, groups,
// materials) is checked no further and left out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace edgecase {

struct ObjCheck {
  // The first fault: its line, from 1 (0: the file as a whole). No fault: an empty message.
  std::size_t line = 0;
  std::string message;
  std::string remedy;

  std::string cleaned;        // OBJ text: "v", "vt" and "f" lines, indices from 1
  std::size_t triangles = 0;  // that its faces make
  bool has_colors = false;    // every vertex has one; else none has
};

// Vertices: "v x y z", "v x y z 1" or "v x y z r g b", magnitudes up to 2^64. Texture
// coordinates: "vt u", "vt u v" or "vt u v w", of which w is left out. Faces: 3 to 255 corners.
// Refused: lines and points, curves and surfaces, files without faces or with more
// triangles than a case may have.
ObjCheck check_obj(std::string_view text);

}  // namespace edgecase
