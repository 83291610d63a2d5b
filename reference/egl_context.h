// SPDX-License-Identifier: MIT
//
// EGL without a window system: Mesa's surfaceless platform, a device by its number or name, or a
// library that is not the system's, ANGLE's for instance.
//
// The context is current without any surface until a scene requests a window surface; pbuffers,
// kept by size, then serve as windows. Device numbers are positions in the list of
// EGL_EXT_device_enumeration: real hardware comes first if there is any, and Mesa adds one software
// device.
#pragma once

#include <string>

#include "reference/gl_context.h"

namespace edgecase {

ContextResult make_egl_surfaceless_context(GlApi api);

// index: from 0, in the order of eglQueryDevicesEXT.
ContextResult make_egl_device_context(GlApi api, int index);

// name: three letters or more, which the description of exactly one device (describe_device) has to
// hold, in upper or lower case.
ContextResult make_egl_device_context(GlApi api, const std::string& name);

// path: of a libEGL, or of the folder that holds one. Of ANGLE, the platform that its variable
// ANGLE_DEFAULT_PLATFORM names is tried first, then Vulkan, then Vulkan by SwiftShader.
ContextResult make_egl_library_context(GlApi api, const std::string& path);

// The number of devices that EGL lists; 0 if there is no EGL, or it cannot list them.
int count_egl_devices();

}  // namespace edgecase
