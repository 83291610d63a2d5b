// SPDX-License-Identifier: MIT
//
// A project's settings: edgecase.toml, with the options that all its commands share. The page
// reports/pages/renderers.md shows its keys.
//
// Every key is an option, and an option on the command line wins. Paths are relative to the file's
// folder, in which programs are also started, so commands work in any folder of the project.
//
// The file takes effect unasked, wherever somebody works below its folder. So it is refused if
// others can write it (file_safety.h), its programs wait for a word (trust.h), and what it lets
// commands write stays in its folder. The page reports/pages/security.md says so to users.
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
  std::filesystem::path file;    // absolute
  std::string text;              // of the file
  std::filesystem::path folder;  // of the file, from here
  bool is_writable_by_others = false;
  std::map<std::string, std::string> renderers;  // name -> address
  // Option, or positional argument -> its values in the file.
  std::map<std::string, std::vector<std::string>> options;
  // Option -> why its value in the file does not do.
  std::map<std::string, std::string> refused;

  // Sets those of the options `wanted` that the line of a parsed command does not give. Throws
  // ProjectError for one that is refused.
  void give(CLI::App& command, const std::vector<std::string>& wanted) const;
  // Throws ProjectError if the name is similar to that of one of its renderers.
  void refuse_misspelt(const std::string& renderer) const;
};

// --config, the variable EDGECASE_CONFIG and --trust, and what a command takes from the file.
struct ProjectOption {
  std::string config;       // the file; empty: the nearest
  bool is_trusted = false;  // what the file names may be run
  bool runs = true;         // set it to false for a command that runs no renderer
  // The folders of renderers of the project, as RendererOptions has them.
  std::map<std::string, std::string> folders;

  void add_to(CLI::App& command);
  void add_config_to(CLI::App& command);
  // Gives the parsed command its options, as Project::give does, and renderers that are named by
  // the project their addresses. Where none is named and `asks_all`, all of the project are. Throws
  // ProjectError, also where the command runs what may not be run.
  void take(CLI::App& command, std::vector<std::string>& named,
            const std::vector<std::string>& wanted, bool asks_all = false);
  void take(CLI::App& command, std::string& named, const std::vector<std::string>& wanted);
};

// The project of the file `config` or, if that is empty, of the nearest edgecase.toml from the
// working folder upward, which is named on standard error; nothing if there is none, or for the
// file /dev/null. Throws ProjectError, also for a file that was not named and that others can
// write.
std::optional<Project> find_project(const std::string& config);

}  // namespace edgecase
