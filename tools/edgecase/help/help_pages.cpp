// SPDX-License-Identifier: MIT
#include "tools/edgecase/help/help_pages.h"

#include <fmt/format.h>

#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace edgecase {
namespace {

// By code; what 1 means is each page's.
constexpr std::array kMeanings = {"as expected",
                                  "",
                                  "usage or case error",
                                  "input, output or internal error",
                                  "a renderer is missing, crashed or came too late",
                                  "nothing is selected"};

constexpr const char* kInterrupted = "interrupted";

constexpr HelpPage kPages[] = {
    {"run",
     "Every case is rendered exactly and by each renderer, compared, and judged by the "
     "specification. Each answer is held against the expectations that are committed for its "
     "renderer. With no file named, results.json, junit.xml and report.html go to out/. A run that "
     "is interrupted keeps what was finished, and --resume goes on with the rest.",
     "012345", "an answer is not as expected, an unexpected agreement included",
     "edgecase run\n"
     "edgecase run cases/lines --against osmesa:softpipe --html lines.html\n"
     "edgecase run --against \"exec:python3 my_rasterizer.py\" --filter \"triangles/*\"\n"
     "edgecase run --shard 2/4 --json 2.json\n"
     "edgecase run --json results.json --resume"},
    {"render",
     "Writes a rendering of each case, pixels and every fragment, or a picture of it. Nothing is "
     "compared or judged.",
     "012345", kInterrupted,
     "edgecase render cases/triangles/ties --with osmesa:llvmpipe\n"
     "edgecase render cases/scenes --png pictures"},
    {"explain",
     "Draws a case in characters and says in sentences which rule decides over a pixel; with "
     "--against also where the renderer differs, the cause, and the ruling that it is judged by.",
     "012345", kInterrupted,
     "edgecase explain cases/lines/short/between-diamonds.json --pixel 3,3\n"
     "edgecase explain cases/triangles/ties/flat-top.json --pixel 3,3 --svg pixel.svg\n"
     "edgecase explain cases/lines/short/between-diamonds.json --against osmesa:softpipe\n"
     "edgecase explain cases/triangles/single/across-blocks.json --blocks 4 --svg blocks.svg"},
    {"profile",
     "Asks the renderer for thousands of random scenes and infers from its answers which "
     "alternative of each rule it follows, with the evidence and the counter-examples.",
     "01234", "interrupted; nothing was written",
     "edgecase profile --against osmesa:llvmpipe --scenes 2000\n"
     "edgecase profile --against egl:device0 --policy-file device0.json"},
    {"record",
     "Writes every answer of the renderer into one file. Where it cannot run, recording:FILE "
     "stands for it in every other subcommand.",
     "012345", kInterrupted,
     "edgecase record --against egl:device0 -o card.rec\n"
     "edgecase record cases/lines --against osmesa:softpipe -o lines.rec"},
    {"rules",
     "Each rule with its section of the specification, the latitude that this grants, the "
     "alternatives, and the numbered rulings that verdicts cite. --book writes pages that teach "
     "them, with scenes in the words of explain.",
     "023", nullptr,
     "edgecase rules\n"
     "edgecase rules --json\n"
     "edgecase rules --book out/book"},
    {"backends",
     "Believes nothing that a renderer says of itself: each is asked to render. Programs behind "
     "exec: are also held against the protocol, well-formed and malformed requests alike.",
     "01234", "a program does not keep the protocol, or interrupted",
     "edgecase backends\n"
     "edgecase backends \"exec:python3 my_rasterizer.py\" --json -"},
    {"new",
     "Writes a case file that is valid from the start; what is left to its author are the words "
     "and the drawing of what must come out.",
     "023", nullptr,
     "edgecase new cases/lines/mine.json --draw \"lines 0.5,~0.3 9,1+1/2\" --rule "
     "line.diamond-exit\n"
     "edgecase new - --rule line.snap"},
    {"validate",
     "Names every fault of every file, with its line, JSON pointer and remedy, and holds the "
     "drawings of the files against what exact draws.",
     "01235", "a drawing is not what exact draws, or a file is not laid out as asked",
     "edgecase validate\n"
     "edgecase validate cases/lines --check-format"},
    {"bless",
     "Shows how the expectations would change so that the results are expected, a reason on each "
     "line; --apply writes them. Decisions that a reviewer exported from the HTML report are "
     "taken with --from.",
     "0123", "a decision is refused, since something has changed since it was made",
     "edgecase bless out/results.json --against osmesa:softpipe\n"
     "edgecase bless --from decisions.json --apply"},
    {"merge",
     "Judges the cases of all shards anew, as one run: the results are those that a run without "
     "shards would have written.",
     "012345", "an answer is not as expected, or shards are missing",
     "edgecase merge 1.json 2.json 3.json 4.json --html report.html\n"
     "edgecase merge 1.json 3.json --partial -o part.json"},
    {"compare", "Tells which cases became worse, better or other, grouped by rule and cause.",
     "0123", "the two differ",
     "edgecase compare old.json new.json\n"
     "edgecase compare old.json new.json --markdown changes.md"},
    {"report",
     "Writes any of the reports that a run can write. The case files are read for their text, "
     "where they are still what they were.",
     "023", nullptr,
     "edgecase report out/results.json --html report.html\n"
     "edgecase report new.json --since old.json --html report.html"},
    {"separation",
     "Draws every case under every alternative of each rule. A pair of alternatives that no case "
     "tells apart is a hole in the suite.",
     "01235", "some pair is told apart by fewer cases than --least",
     "edgecase separation --least 10\n"
     "edgecase separation cases/lines --full"},
    {"draw",
     "A picture, in characters or SVG: a panel for each alternative, or exact, difference and "
     "renderer side by side.",
     "012345", kInterrupted,
     "edgecase draw cases/lines/algorithms/all-differ.json --svg lines.svg\n"
     "edgecase draw cases/lines/joints/twice-on-a-corner.json --against osmesa:llvmpipe"},
    {"gallery",
     "One page a policy: each choice that is not OpenGL's, with its source and a picture that "
     "shows it.",
     "012345", kInterrupted,
     "edgecase gallery\n"
     "edgecase gallery scotty3d --html pages"},
    {"fuzz",
     "Asks renderers for scenes that a seed fixes, and for mutations of --corpus; what differs is "
     "made small, grouped by rule, kind and cause, and can be saved as cases.",
     "01234", "something was found",
     "edgecase fuzz --against osmesa:softpipe --seconds 60\n"
     "edgecase fuzz --against osmesa:llvmpipe --rules triangle.fill-rule --count 10000 --save "
     "finds"},
    {"minimize",
     "Takes primitives, state, pixels and digits away for as long as the renderer shows the same "
     "difference, and prints what is left as a case file.",
     "012345", "interrupted; the smallest scene so far is printed",
     "edgecase minimize cases/lines/diagonals/two-in-a-column.json --against osmesa:softpipe"},
    {"bench",
     "Draws the same scenes by exact and by renderers in turn, and times cases, searches and "
     "comparisons of pictures. Times depend on the machine; what counts are the ratios.",
     "0235", "",
     "edgecase bench\n"
     "edgecase bench --part scenes --against egl:softpipe --rounds 3 --json bench.json"},
    {"manual",
     "The manual page holds every subcommand with all its options, made of what this program "
     "knows; the completions likewise.",
     "023", nullptr,
     "edgecase manual | man -l -\n"
     "edgecase manual --completion bash > ~/.local/share/bash-completion/completions/edgecase"},
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
  for (CLI::App* command : app.get_subcommands({}))
    command->footer(footer_of(help_page(command->get_name())));
}

}  // namespace edgecase
