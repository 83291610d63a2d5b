// SPDX-License-Identifier: MIT
//
// From the name of a renderer to the renderer.
#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "processes/process_renderer.h"

namespace edgecase {

// The renderers in processes of their own, by their names on the command line.
//
//   osmesa:llvmpipe osmesa:softpipe egl:llvmpipe egl:softpipe egl:zink egl:zink-swiftshader
//   egl:deviceN egl:device=NAME egl:lib=PATH exec:PROGRAM
//
// and of OpenGL ES egl-es:llvmpipe egl-es:softpipe egl-es:zink egl-es:deviceN egl-es:device=NAME
// egl-es:lib=PATH, and of WebGL 2 in browsers webgl:chromium webgl:chromium-gl webgl:firefox. Paths
// count from the folder of the project that names the renderer, or from here.
//
// The OpenGL ones are one program, edgecase-gl, with different arguments and environments: Mesa
// chooses its driver by environment variables that it reads once per process. Those of WebGL are
// another program, edgecase-webgl, which starts the browser.

// The renderers of OpenGL core, and those of OpenGL ES; of devices, the first.
const std::vector<std::string>& opengl_renderer_names();
const std::vector<std::string>& opengl_es_renderer_names();
const std::vector<std::string>& webgl_renderer_names();

// Names for messages: all that the command line knows, patterns included.
std::string known_renderer_names();

// A renderer on the command line: "mine=exec:./r", or an address alone, which then is the name as
// well.
struct NamedRenderer {
  std::string name;
  std::string address;
};
NamedRenderer split_name(const std::string& renderer);

// The reason why a name is no renderer: one sentence with the known names.
struct UnknownRenderer {
  std::string message;
};

// How to start the renderer of this name. `program_directory` holds the worker programs edgecase-gl
// and edgecase-webgl: worker_directory(). The first scene shows whether the renderer works.
//
// exec:PROGRAM is the path of an existing file, or else a command line: words separated by spaces,
// with single or double quotes around words that contain some. The first word is a path (a file in
// the working folder needs no "./"), or is looked up in PATH. The program is started in `folder`,
// where one is given, and its paths count from there.
std::variant<ProcessSpec, UnknownRenderer> find_renderer(const std::string& renderer,
                                                         const std::string& program_directory,
                                                         const std::string& folder = "");

// Whether a renderer, with or without names before its address, runs code from where that says: a
// program of exec:, or a library of egl:lib= or egl-es:lib=.
bool is_foreign_code(const std::string& renderer);

// The number of devices that EGL lists, as egl:device0 and so on; 0 without an EGL that lists them.
// The worker program counts them, so that a driver's crash does no harm here.
int listed_egl_devices(const std::string& program_directory);

// The folder of the worker program: that of the running executable (/proc/self/exe; "." if that
// cannot be read), as built, or the library's folder of the prefix in which it is installed.
std::string worker_directory();

struct RendererOptions {
  Policy policy;                            // of the renderer `exact`
  std::chrono::milliseconds timeout{};      // per scene
  std::string program_directory;            // where the OpenGL worker lies
  const std::atomic<bool>* stop = nullptr;  // as ProcessSpec has it
  // By renderers' names: the folders that their programs are started in; others in our own.
  std::map<std::string, std::string> folders{};
};

// `exact`, `recording:FILE` or what find_renderer knows, with or without a name of its own before
// it: "mine=exec:./r". Otherwise a sentence that says why it is none.
std::variant<std::unique_ptr<Renderer>, std::string> make_renderer(const std::string& renderer,
                                                                   const RendererOptions& options);

}  // namespace edgecase
