// SPDX-License-Identifier: MIT
//
// The renderers that live in processes, by the names that the command line gives them.
//
//   osmesa:llvmpipe osmesa:softpipe egl:llvmpipe egl:softpipe egl:zink egl:zink-swiftshader
//   egl:deviceN exec:PROGRAM
//
// and of OpenGL ES egl-es:llvmpipe egl-es:softpipe egl-es:zink egl-es:deviceN.
//
// The OpenGL ones are all the same program, edgecase-gl; what differs is its argument and the
// environment it is started in, since Mesa chooses its driver by environment variables that it
// reads once per process.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "run/process_renderer.h"

namespace edgecase {

// The renderers of OpenGL core, and those of OpenGL ES; of devices, the first.
const std::vector<std::string>& opengl_renderer_names();
const std::vector<std::string>& opengl_es_renderer_names();

// Names for messages: all that the command line knows, patterns included.
std::string known_renderer_names();

// A renderer as the command line names it: "mine=exec:./r", or without a name of its own, which
// then is its address.
struct NamedRenderer {
  std::string name;
  std::string address;
};
NamedRenderer split_name(const std::string& renderer);

// Why a name is no renderer: one sentence with the known names.
struct UnknownRenderer {
  std::string message;
};

// How to start the renderer of this name. `program_directory` holds the worker program edgecase-gl:
// worker_directory(). Whether the renderer works is for the first scene to show.
//
// exec:PROGRAM is the path of an existing file, or else a command line: words separated by spaces,
// with single or double quotes around words that contain some. The first word is a path (a file in
// the working folder needs no "./"), or is looked up in PATH. The program is started in `folder`,
// where one is given, and its paths count from there.
std::variant<ProcessSpec, UnknownRenderer> find_renderer(const std::string& renderer,
                                                         const std::string& program_directory,
                                                         const std::string& folder = "");

// How many devices EGL lists, as the worker program finds it: egl:device0 and so on. 0 where there
// is no EGL that lists them. Asked of another process: a driver that crashes takes nothing with it.
int listed_egl_devices(const std::string& program_directory);

// Where the running executable (/proc/self/exe; "." where that cannot be read) has the worker
// program: beside it, as built, or in the library's folder of the prefix it is installed in.
std::string worker_directory();

}  // namespace edgecase
