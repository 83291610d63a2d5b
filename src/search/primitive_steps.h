// SPDX-License-Identifier: MIT
//
// Steps towards fewer primitives: draws, primitives of a draw and vertices of a strip are left out,
// first many at once; strips, loops and fans become separate primitives; draws alike become one.
#pragma once

#include "search/shrinking.h"

namespace edgecase {

// The same primitives without shared vertices, each with its vertices in the order of assembly. A
// draw that has none already stays as it is.
Draw separated(const Scene& scene, std::size_t draw);

// Each returns whether anything was kept.

// Only what the find is on, and with each other primitive beside it.
bool keep_only_finds(Shrinking& shrinking);
bool leave_out_draws(Shrinking& shrinking);
bool separate_primitives(Shrinking& shrinking);
// Primitives of a draw; of strips, loops and fans that stay, vertices.
bool leave_out_primitives(Shrinking& shrinking);
bool join_draws(Shrinking& shrinking);

}  // namespace edgecase
