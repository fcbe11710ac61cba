// `zstrip font`: a TrueType font as constants for firmware.
#include "cli/font_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bake/scene_header.hpp"
#include "cli/print.hpp"
#include "font/characters.hpp"
#include "font/converted_font.hpp"
#include "font/font_header.hpp"
#include "image/write_file.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// The options as given on the command line.
struct FontArguments {
  std::string file, output;
  std::uint32_t size = 16;
  std::uint32_t bits = 4;
  std::string characters = " -~";
  std::optional<std::string> replacement;
  std::string name_space = "font";
  bool quiet = false;
};

Failure wrong_option(const std::string& message) { return {ExitStatus::usage, message}; }

Result<FontRequest> parse_font(const FontArguments& arguments) {
  const std::string extension = std::filesystem::path(arguments.output).extension().string();
  if (extension != ".hpp" && extension != ".h") {
    return wrong_option(fmt::format("-o '{}' must end in .hpp (C++ constants)", arguments.output));
  }
  if (arguments.size < kMinFontSize || arguments.size > kMaxFontSize) {
    return wrong_option(fmt::format("--size {} must be {} to {} pixels", arguments.size, kMinFontSize, kMaxFontSize));
  }
  if (arguments.bits != 1 && arguments.bits != 4 && arguments.bits != 8) {
    return wrong_option(fmt::format("--bits {} must be 1, 4 or 8", arguments.bits));
  }
  if (!is_namespace(arguments.name_space)) {
    return wrong_option(
        fmt::format("--namespace '{}' must be lower case letters, digits and single underscores between them, neither "
                    "std nor zstrip, and no word of C++",
                    arguments.name_space));
  }
  FontRequest request{.file = arguments.file,
                      .size = arguments.size,
                      .bits = static_cast<std::uint8_t>(arguments.bits),
                      .characters = {},
                      .replacement = {}};
  Result<std::vector<std::uint32_t>> characters = parse_characters(arguments.characters);
  if (!characters) return characters.failure();
  request.characters = std::move(*characters);
  if (arguments.replacement) {
    const std::vector<std::uint32_t> given = code_points_of(*arguments.replacement);
    if (given.size() != 1) return wrong_option("--replacement must be one character in UTF-8");
    request.replacement = given[0];
  }
  return request;
}

/// Lists the characters that the file does not have.
std::string list_of_missing(const std::vector<std::uint32_t>& characters) {
  constexpr std::size_t kMaxNamed = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(characters.size(), kMaxNamed); ++i) {
    list += (i == 0 ? "" : ", ") + name_of_character(characters[i]);
  }
  if (characters.size() > kMaxNamed) list += fmt::format(" and {} more", grouped(characters.size() - kMaxNamed));
  return list;
}

Result<Done> run_font(const FontArguments& arguments) {
  const Result<FontRequest> request = parse_font(arguments);
  if (!request) return request.failure();
  const Result<ConvertedFont> converted = convert_font(*request);
  if (!converted) return converted.failure();
  const std::vector<std::uint32_t>& missing = converted->missing;
  const Font& font = converted->font;
  if (request->replacement && std::ranges::find(missing, *request->replacement) != missing.end()) {
    return wrong_option(
        fmt::format("--replacement: '{}' has no {}", arguments.file, name_of_character(*request->replacement)));
  }
  if (!missing.empty()) {
    print_warning(fmt::format("'{}' does not have {}; left out", arguments.file, list_of_missing(missing)));
  }
  const std::string source =
      fmt::format("{}, {} pixels, {} bits", std::filesystem::path(arguments.file).filename().string(), arguments.size,
                  arguments.bits);
  const std::string header = to_font_header(font, source, arguments.name_space);
  const Result<Done> written =
      write_file(arguments.output, {reinterpret_cast<const std::uint8_t*>(header.data()), header.size()}, "-o");
  if (!written) return written.failure();
  if (!arguments.quiet) {
    write_text(stdout, fmt::format("{}: {}, {} a line, {} of glyphs and {} of coverage\n", printable(arguments.output),
                                   counted(font.glyphs.size(), "character"), counted(font.line_height, "pixel"),
                                   counted(font.glyphs.size_bytes(), "byte"),
                                   counted(font.coverage.size_bytes(), "byte")));  // main checks the stream's state
  }
  return Done{};
}

}  // namespace

void add_font_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("font", "Write a TrueType or OpenType font for firmware, as C++ constants");
  const auto arguments = std::make_shared<FontArguments>();
  FontArguments& a = *arguments;
  command->add_option("font", a.file, "A font with outlines (.ttf .otf ...)")->required()->type_name("FILE");
  command->add_option("-o,--output", a.output, "The header to write (.hpp)")->required()->type_name("FILE");
  command->add_option("--size", a.size, "Pixels of the em square, 4 to 200")
      ->type_name("PIXELS")
      ->capture_default_str();
  command->add_option("--bits", a.bits, "Bits of a pixel's coverage: 1, 4 or 8")
      ->type_name("BITS")
      ->capture_default_str();
  command
      ->add_option("--characters", a.characters, "Characters in UTF-8; A-Z stands for all from A to Z (default: ASCII)")
      ->type_name("TEXT");
  command
      ->add_option("--replacement", a.replacement,
                   "Character that replaces missing ones (default: U+FFFD, if the font has it)")
      ->type_name("CHARACTER");
  command
      ->add_option("--namespace", a.name_space,
                   "Namespace of the header's constants, so that one program can have several headers")
      ->type_name("NAME")
      ->capture_default_str();
  command->add_flag("--quiet", a.quiet, "No report; warnings and errors remain");
  command->footer(
      "Examples:\n"
      "  zstrip font DejaVuSans.ttf --size 16 --bits 4 --characters \"A-Za-z0-9ÄÖÜ\" -o font.hpp\n"
      "  zstrip font DejaVuSansMono.ttf --size 48 --characters \"0-9:\" -o clock.hpp --namespace clock_font\n"
      "  zstrip font DejaVuSans.ttf --size 10 --bits 1 --replacement \"?\" -o small.hpp");
  command->callback([arguments, &exit_code] {
    const Result<Done> done = run_font(*arguments);
    exit_code = done ? static_cast<int>(ExitStatus::ok) : print_failure(done.failure());
  });
}

}  // namespace zstrip::sim
