// SPDX-License-Identifier: MIT
#include "tools/edgecase/help/help_pages.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "tools/edgecase/help/wrapped_formatter.h"

namespace edgecase {
namespace {

// By code; each page gives its own meaning of 1.
constexpr std::array kMeanings = {"as expected",
                                  "",
                                  "usage or case error",
                                  "input, output or internal error",
                                  "a renderer is missing, crashed or timed out",
                                  "nothing is selected",
                                  "a renderer drew nothing of what it was asked for"};

constexpr const char* kInterrupted = "interrupted";

constexpr const char* kRun = "Run";
constexpr const char* kUnderstand = "Understand";
constexpr const char* kWrite = "Write cases";
constexpr const char* kSearch = "Search";
constexpr const char* kMaintain = "Maintain";

constexpr HelpPage kPages[] = {
    {"run", kRun,
     "Every case is rendered exactly and by each renderer. The two renderings are compared, and "
     "the differences are judged by the specification. What the "
     "specification forbids is held against the known faults of the driver. If no option names a "
     "file, results.zst, "
     "junit.xml and report.html go to out/. An interrupted run keeps the finished cases, and "
     "--resume runs the rest.",
     "0123456", "an answer is unexpected, or a known fault has grown",
     "edgecase run\n"
     "edgecase run lines --against egl:softpipe --html lines.html\n"
     "edgecase run \"triangles/*\" --against \"exec:python3 my_rasterizer.py\" --open\n"
     "edgecase run --shard 2/4 --json 2.zst\n"
     "edgecase run --sample 1/50 --against egl:softpipe\n"
     "edgecase run --json results.zst --resume"},
    {"report", kRun,
     "The reports are those that a run can write. The text of a case file is shown if the file has "
     "not changed since the run.",
     "023", nullptr,
     "edgecase report out/results.zst --html report.html --open\n"
     "edgecase report new.zst --since old.zst --html report.html"},
    {"compare", kRun,
     "Each case is worse, better, different or unchanged. Changes are grouped by rule and cause.",
     "0123", "the two differ",
     "edgecase compare old.zst new.zst\n"
     "edgecase compare old.zst new.zst --markdown changes.md"},
    {"generations", kRun,
     "Of each driver in the results: its known faults against its releases, in how many cases "
     "each shows, and which releases were the first and the last to show it.",
     "023", nullptr,
     "edgecase generations bookworm.zst trixie.zst sid.zst\n"
     "edgecase generations bookworm.zst trixie.zst sid.zst --markdown faults.md"},
    {"merge", kRun,
     "The cases of all shards are judged anew, as one run. The results are those that a run "
     "without shards would have written.",
     "0123456", "an answer is not as expected, or shards are missing",
     "edgecase merge 1.zst 2.zst 3.zst 4.zst --html report.html\n"
     "edgecase merge 1.zst 3.zst --partial -o part.zst"},
    {"record", kRun,
     "All answers of the renderer go into one file. Every other subcommand accepts recording:FILE "
     "in place of the renderer, also where the renderer cannot run.",
     "012345", kInterrupted,
     "edgecase record --against egl:device0 -o card.rec\n"
     "edgecase record lines --against egl:softpipe -o lines.rec"},
    {"web", kRun,
     "The page is one file, and needs no network. It draws with WebGL 2, shows how it goes, and "
     "saves a recording, which any command takes as recording:FILE. Without a selection it has the "
     "cases of --suite core.",
     "0235", nullptr,
     "edgecase web -o page.html\n"
     "edgecase web lines triangles -o page.html\n"
     "edgecase web --live triangles/shared-edges/hole-where-x-is-a-third -o case.html"},
    {"render", kRun,
     "Each case gives its pixels and every fragment, or a picture. Nothing is compared or judged.",
     "012345", kInterrupted,
     "edgecase render triangles/ties --with egl:llvmpipe\n"
     "edgecase render scenes --png pictures"},
    {"explain", kUnderstand,
     "The case is drawn in characters, and sentences say which rule decides over a pixel. With "
     "--against they also say where the renderer differs, the cause, and the ruling that judges "
     "it.",
     "012345", kInterrupted,
     "edgecase explain lines/short/between-diamonds --pixel 3,3\n"
     "edgecase explain triangles/ties/flat-top --pixel 3,3 --svg pixel.svg\n"
     "edgecase explain lines/short/between-diamonds --against egl:softpipe\n"
     "edgecase explain triangles/single/across-blocks --blocks 4 --svg blocks.svg"},
    {"draw", kUnderstand,
     "The picture is text or SVG. It has a panel for each alternative of a rule; with --against it "
     "has exact, the difference and the renderer side by side.",
     "012345", kInterrupted,
     "edgecase draw lines/algorithms/all-differ --svg lines.svg\n"
     "edgecase draw lines/joints/twice-on-a-corner --against egl:llvmpipe"},
    {"rules", kUnderstand,
     "A rule is printed with its section of the specification, the latitude that the section "
     "grants, its alternatives, and the numbered rulings that verdicts cite. --book writes pages "
     "that teach the rules by worked scenes.",
     "023", nullptr,
     "edgecase rules\n"
     "edgecase rules line.diamond-exit\n"
     "edgecase rules \"texture.*\" --json\n"
     "edgecase rules --book out/book"},
    {"profile", kUnderstand,
     "The renderer draws 16 cases of each rule and surface, or the cases that are named, in "
     "rounds: "
     "its answers show which alternative of each rule it follows, and are then held against those. "
     "A summary of ten lines is printed; --full prints what was asked of each rule before it.",
     "012345", "interrupted; nothing was written",
     "edgecase profile --against egl:llvmpipe\n"
     "edgecase profile --against egl:device0 --full --policy-file device0.json"},
    {"gallery", kUnderstand,
     "Each policy has a page. It shows each choice that differs from OpenGL's, with its source and "
     "a picture.",
     "012345", kInterrupted,
     "edgecase gallery\n"
     "edgecase gallery scotty3d --html pages"},
    {"new", kWrite,
     "The new file is valid. Its author corrects the words and draws the expected result.", "023",
     nullptr,
     "edgecase new cases/lines/mine.json --draw \"lines 0.5,~0.3 9,1+1/2\" --rule "
     "line.diamond-exit\n"
     "edgecase new - --rule line.snap"},
    {"validate", kWrite,
     "Every fault is reported with its line, JSON pointer and remedy. The drawings in the files "
     "are compared with what exact draws.",
     "01235", "a drawing is not what exact draws, or a file has another layout",
     "edgecase validate\n"
     "edgecase validate cases/lines --check-format"},
    {"separation", kWrite,
     "Every case is drawn under every alternative of each rule. A pair of alternatives that no "
     "case tells apart is a hole in the suite.",
     "01235", "fewer cases than --least tell some pair apart",
     "edgecase separation --least 10\n"
     "edgecase separation --cover --least 3 -o cases/core.txt\n"
     "edgecase separation lines --full"},
    {"fuzz", kSearch,
     "Renderers draw scenes that the seed determines, and mutations of the scenes of --corpus. "
     "Each disagreement is minimized and can be saved as a case. Finds are grouped by rule, kind "
     "and cause.",
     "01234", "something was found",
     "edgecase fuzz --against egl:softpipe --seconds 60\n"
     "edgecase fuzz --against egl:llvmpipe --rules triangle.fill-rule --count 10000 --save "
     "finds"},
    {"minimize", kSearch,
     "Primitives, state, pixels and digits are removed while the renderer shows the same "
     "difference. The remaining scene is printed as a case file.",
     "012345", "interrupted; the smallest scene so far is printed",
     "edgecase minimize lines/diagonals/two-in-a-column --against egl:softpipe"},
    {"bless", kMaintain,
     "Unexpected violations become known faults, with a reason, and faults that do not show any "
     "more are closed. The changes are printed, and --apply writes them. --from takes the "
     "decisions that a reviewer exported from the HTML "
     "report.",
     "0123", "a decision is refused because something has changed since it was made",
     "edgecase bless out/results.zst --against egl:softpipe\n"
     "edgecase bless --from decisions.json --apply"},
    {"backends", kMaintain,
     "Each renderer is tested by what it renders, not by what it reports. Programs behind exec: "
     "also get well-formed and malformed requests of the protocol.",
     "01234", "a program does not keep the protocol, or interrupted",
     "edgecase backends\n"
     "edgecase backends \"exec:python3 my_rasterizer.py\" --json -"},
    {"bench", kMaintain,
     "Exact and renderers draw the same scenes in turn. Cases, searches and comparisons of "
     "pictures are timed, too. Times depend on the machine, so compare ratios.",
     "0235", "",
     "edgecase bench\n"
     "edgecase bench --part scenes --against egl:softpipe --rounds 3 --json bench.json"},
    {"manual", kMaintain,
     "The manual page holds every subcommand with all its options. It and the completions are "
     "generated from the program's own options.",
     "023", nullptr,
     "edgecase manual | man -l -\n"
     "edgecase manual --completion bash > ~/.local/share/bash-completion/completions/edgecase"},
    {"help", kMaintain, "The help of a subcommand is what its option --help prints.", "023",
     nullptr,
     "edgecase help\n"
     "edgecase help run"},
};

std::string footer_of(const HelpPage& page) {
  std::string text = fmt::format("{}\n\nExit codes: ", page.purpose);
  std::string codes;
  for (const std::string& line : exit_code_lines(page)) codes += (codes.empty() ? "" : ", ") + line;
  text += codes + ".\n\nExamples:\n";
  std::istringstream lines(page.examples);
  for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  text.pop_back();
  return text;
}

}  // namespace

std::span<const HelpPage> help_pages() {
  return kPages;
}

const HelpPage& help_page(const std::string& name) {
  for (const HelpPage& page : kPages)
    if (name == page.name) return page;
  throw std::out_of_range("no help page for the subcommand " + name);
}

std::vector<std::string> exit_code_lines(const HelpPage& page) {
  std::vector<std::string> lines;
  for (const char* code = page.exits; *code != '\0'; ++code)
    lines.push_back(fmt::format(
        "{} {}", *code,
        *code == '1' ? page.code_one : kMeanings.at(static_cast<std::size_t>(*code - '0'))));
  return lines;
}

void add_help_pages(CLI::App& app) {
  const auto formatter = std::make_shared<WrappedFormatter>(help_width());
  app.formatter(formatter);
  for (CLI::App* command : app.get_subcommands({})) {
    const HelpPage& page = help_page(command->get_name());
    command->group(page.group);
    command->footer(footer_of(page));
    command->formatter(formatter);
  }
}

}  // namespace edgecase
