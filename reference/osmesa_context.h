// SPDX-License-Identifier: MIT
//
// OSMesa: Mesa's software drivers in a separate library, without any window system.
//
// The environment variable GALLIUM_DRIVER chooses llvmpipe or softpipe; it must be set before the
// process starts. The context is always bound to a buffer in memory, which is its window: a small
// one until a scene requests a window surface. Mesa has no OSMesa since 25.1: the library is opened
// at run time, and its header is not needed.
#pragma once

#include "reference/gl_context.h"

namespace edgecase {

ContextResult make_osmesa_context();

}  // namespace edgecase
