// Messages about command lines.
#include "cli/usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "cli/nearest_name.hpp"

namespace zstrip::sim {
namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Returns the names of the commands that have this option, with "and" between them.
std::string commands_with(const CLI::App& app, const std::string& option) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands({})) {
    if (command->get_option_no_throw(option) != nullptr) names.push_back(command->get_name());
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

/// Returns the first unknown option of the words that were not parsed, or else the unknown command; empty if there is
/// none.
std::string unknown(const CLI::App& app, const CLI::App& chosen) {
  std::vector<std::string> left = app.remaining(true);
  std::erase(left, "--");
  const auto option = std::ranges::find_if(left, [](std::string_view word) { return word.starts_with("--"); });
  if (option == left.end() && (&chosen != &app || left.empty())) return {};
  const std::string word = option == left.end() ? left.front() : option->substr(0, option->find('='));
  const std::vector<std::string> names = option == left.end() ? names_of_commands(app) : names_of_options(chosen);
  if (std::ranges::find(names, word) != names.end())
    return fmt::format("'{}' comes after '--', which ends the options", word);
  if (const std::string others = commands_with(app, word); option != left.end() && !others.empty()) {
    return fmt::format("'{}' is an option of {}; {} has none of that name", word, others, chosen.get_name());
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return fmt::format("'{}' is unknown, did you mean {}?", word, nearest_name(word, known));
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands();
  const CLI::App& chosen = commands.empty() ? app : *commands.front();
  std::string message;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) message = unknown(app, chosen);
  if (message.empty()) message = error.what();
  return fmt::format("{}; see 'zstrip{}{} --help'", message, commands.empty() ? "" : " ",
                     commands.empty() ? "" : chosen.get_name());
}

}  // namespace zstrip::sim
