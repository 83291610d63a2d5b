// SPDX-License-Identifier: MIT
//
// OSMesa: Mesa's software drivers inside a library of their own, without any window system.
//
// The environment variable GALLIUM_DRIVER chooses llvmpipe or softpipe; it must be set before the
// process starts. The context is bound to a small buffer of its own, and all drawing goes to
// framebuffer objects. Newer releases of Mesa no longer have OSMesa.
#pragma once

#include "reference/gl_context.h"

namespace edgecase {

ContextResult make_osmesa_context();

}  // namespace edgecase
