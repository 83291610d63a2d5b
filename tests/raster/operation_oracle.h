// SPDX-License-Identifier: MIT
//
// What becomes of a fragment at one sample, transcribed once more from the specification's text (GL
// 4.6 core, 17.3.3, 17.3.4, 17.3.6 and 17.4.2), slow and literal: colours are quotients of integers
// until they are stored, depths are the integers or the floats of the buffer.
#pragma once

#include <array>

#include "model/scene.h"

namespace edgecase::oracle {

struct Arriving {
  std::array<double, 4> color{};
  double depth = 0;
  bool front_facing = true;
};

// What is stored: colours and stencil values as integers, depths as the quotients that they mean.
struct Stored {
  std::array<int, 4> color{};
  double depth = 1;
  int stencil = 0;
  unsigned hits = 0;
};

Stored cleared(const Target& target);
void arrive(const Arriving& fragment, const FragmentOperations& operations, const Target& target,
            Stored& stored);

// By the area of its vertices, y up, which are multiples of 2^-16.
bool faces_front(const ScenePrimitive& primitive);

}  // namespace edgecase::oracle
