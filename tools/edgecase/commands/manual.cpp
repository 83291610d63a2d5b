// SPDX-License-Identifier: MIT
//
// edgecase manual: the manual page and completions for shells, generated from the program's own
// options.
#include <fmt/format.h>

#include <memory>

#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/help/completions.h"
#include "tools/edgecase/help/manual_page.h"

namespace edgecase {

void add_manual_command(CLI::App& app, ExitCode&) {
  CLI::App* command =
      app.add_subcommand("manual", "Print the manual page, or a shell's completion script");
  auto shell = std::make_shared<std::string>();
  command->add_option("--completion", *shell, "Print the completion script of this shell instead")
      ->check(CLI::IsMember({"bash", "fish"}));
  command->callback([&app, shell] {
    const auto words = words_of(app);
    fmt::print("{}", *shell == "bash"   ? bash_completion(words)
                     : *shell == "fish" ? fish_completion(words)
                                        : manual_page(app.get_description(), words));
  });
}

}  // namespace edgecase
