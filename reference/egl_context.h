// SPDX-License-Identifier: MIT
//
// EGL without a window system: Mesa's surfaceless platform, or a device by its number.
//
// The context is current without any surface until a scene asks for a window surface: pbuffers,
// kept by size, stand in for windows. Device numbers are the positions in the list of
// EGL_EXT_device_enumeration: real hardware comes first where there is one, and Mesa adds one
// software device.
#pragma once

#include "reference/gl_context.h"

namespace edgecase {

ContextResult make_egl_surfaceless_context();

// index: from 0, in the order of eglQueryDevicesEXT.
ContextResult make_egl_device_context(int index);

}  // namespace edgecase
