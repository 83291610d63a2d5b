// SPDX-License-Identifier: MIT
#include "model/texture.h"

#include <algorithm>

namespace edgecase {
int level_size(int size, int level) {
  return level < 31 ? std::max(1, size >> level) : 1;
}

int level_count(int width, int height) {
  int count = 1;
  for (int size = std::max(width, height); size > 1; size /= 2) ++count;
  return count;
}

}  // namespace edgecase
