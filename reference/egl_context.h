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

ContextResult make_egl_surfaceless_context(GlApi api);

// index: from 0, in the order of eglQueryDevicesEXT.
ContextResult make_egl_device_context(GlApi api, int index);

// How many devices EGL lists; 0 where there is no EGL, or one that cannot list them.
int count_egl_devices();

}  // namespace edgecase
