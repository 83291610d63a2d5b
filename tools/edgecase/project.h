// SPDX-License-Identifier: MIT
//
// A project's settings: edgecase.toml, with the options that all its commands share. The page
// reports/pages/renderers.md shows its keys.
//
// Every key is an option, and an option on the command line wins. Paths are relative to the file's
// folder, in which programs are also started, so commands work in any folder of the project.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace edgecase {

// An error in a project's file: "edgecase.toml:3: …", one line, with the remedy.
struct ProjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Stands for all options that a project's file has.
inline const std::vector<std::string> kEveryOption = {"*"};

struct Project {
  std::filesystem::path folder;                  // of the file, from here
  std::map<std::string, std::string> renderers;  // name -> address
  // Option, or positional argument -> its values in the file.
  std::map<std::string, std::vector<std::string>> options;

  // Sets those of the options `wanted` that the line of a parsed command does not give.
  void give(CLI::App& command, const std::vector<std::string>& wanted) const;
  // Throws ProjectError if the name is similar to that of one of its renderers.
  void refuse_misspelt(const std::string& renderer) const;
};

// --config and the variable EDGECASE_CONFIG, and what a command takes from the file.
struct ProjectOption {
  std::string config;                          // the file; empty: the nearest
  std::map<std::string, std::string> folders;  // as RendererOptions has them
  std::vector<std::string> renderers;          // all of the project, NAME=RENDERER

  void add_to(CLI::App& command);
  // Gives the parsed command its options, as Project::give does, and renderers that are named by
  // the project their addresses. Throws ProjectError.
  void take(CLI::App& command, std::vector<std::string>& named,
            const std::vector<std::string>& wanted);
  void take(CLI::App& command, std::string& named, const std::vector<std::string>& wanted);
};

// The project of the file `config` or, if that is empty, of the nearest edgecase.toml from the
// working folder upward; nothing if there is none. Throws ProjectError.
std::optional<Project> find_project(const std::string& config);

}  // namespace edgecase
