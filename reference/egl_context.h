// SPDX-License-Identifier: MIT
//
// EGL without a window system: Mesa's surfaceless platform, or a device by its number.
//
// The context is current without any surface until a scene requests a window surface; pbuffers,
// kept by size, then serve as windows. Device numbers are positions in the list of
// EGL_EXT_device_enumeration: real hardware comes first if there is any, and Mesa adds one software
// device.
#pragma once

#include "reference/gl_context.h"

namespace edgecase {

ContextResult make_egl_surfaceless_context(GlApi api);

// index: from 0, in the order of eglQueryDevicesEXT.
ContextResult make_egl_device_context(GlApi api, int index);

// The number of devices that EGL lists; 0 if there is no EGL, or it cannot list them.
int count_egl_devices();

}  // namespace edgecase
