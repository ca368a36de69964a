// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "lamina/base/edit_distance.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/plugin.hpp"
#include "lamina/base/version.hpp"

namespace lamina::cli {
namespace {

/// The output format that the raw arguments ask for, used where they cannot be parsed.
OutputFormat formatAskedFor(const std::vector<std::string>& arguments) {
  const bool wants_json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
  return wants_json ? OutputFormat::Json : OutputFormat::Text;
}

void printFailure(const Failure& failure, const Counts& counts, OutputFormat format) {
  std::fprintf(stderr, "lamina: %s: %s\n", toString(failure.code), failure.message.c_str());
  if (format == OutputFormat::Text) return;
  nlohmann::ordered_json json = {{"error", {{"code", toString(failure.code)}, {"message", failure.message}}}};
  for (const auto& [what, count] : counts) json[what] = count;
  std::printf("%s\n", json.dump().c_str());
}

/// "; did you mean ...?" with the option of the called subcommand that is nearest to the first one that it
/// does not have; empty if there is none like it.
std::string optionSuggestion(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining(true);
  const auto given = std::find_if(extras.begin(), extras.end(),
                                  [](const std::string& each) { return each.rfind("--", 0) == 0; });
  if (given == extras.end()) return {};
  const CLI::App* called = &app;
  while (!called->get_subcommands().empty()) called = called->get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::Option* option : called->get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return suggestionFor(names, given->substr(0, given->find('=')));
}

/// What the parser says, in words for people where it has none.
std::string messageOf(const CLI::App& app, const CLI::Error& error) {
  std::string message = error.what();
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
    return message + optionSuggestion(app);
  const std::string too_many = ": At Most 1 required but received ";
  const std::size_t at = message.find(too_many);
  if (at == std::string::npos) return message;
  return message.substr(0, at) + " is given " + message.substr(at + too_many.size()) +
         " times; expected once";
}

/// Help that was asked for is a ParseError too.
int refuse(const CLI::App& app, const CLI::ParseError& error, OutputFormat format) {
  const bool is_failure = error.get_exit_code() != 0;
  if (!is_failure || format == OutputFormat::Text) return app.exit(error);
  printFailure({ErrorCode::InvalidConfig, messageOf(app, error)}, {}, format);
  return error.get_exit_code();
}

/// Plug-ins of the command line may stand behind the subcommand too.
void addPluginOption(CLI::App& app, std::vector<std::string>& plugins) {
  app.add_option("--plugin", plugins,
                 "Shared library that adds strategies, modes or formats; may be repeated; others are those "
                 "in LAMINA_PLUGINS")
      ->allow_extra_args(false);
  for (CLI::App* subcommand : app.get_subcommands({})) subcommand->fallthrough();
}

/// The one that is called, or all where none is named first: for their help, and for what to say of a wrong
/// name.
void addSubcommands(CLI::App& app, Chosen& chosen, const std::vector<Subcommand>& subcommands,
                    const std::string& called) {
  const auto found = std::find_if(subcommands.begin(), subcommands.end(),
                                  [&called](const Subcommand& each) { return each.name == called; });
  if (!called.empty() && found != subcommands.end()) return found->add(app, chosen);
  for (const Subcommand& each : subcommands) each.add(app, chosen);
}

/// Whether the subcommand is what is read first: options before it may ask for what concerns all.
bool standsFirst(const std::string& subcommand, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--plugin")
      ++i;
    else
      return argv[i] == subcommand;
  }
  return false;
}

/// What is printed may go to a file, and its disk be full.
/// @throws FileError if not all of it was taken
void requirePrinted() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw FileError(std::string("cannot write the standard output: ") +
                  (errno != 0 ? std::strerror(errno) : "not all of it was taken"));
}

/// Names and aliases of all subcommands that were added.
std::vector<std::string> namesOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(each->get_name());
    for (const std::string& alias : each->get_aliases()) names.push_back(alias);
  }
  return names;
}

}  // namespace

std::vector<std::string> withHelpAsOption(std::vector<std::string> arguments) {
  if (arguments.size() < 2 || arguments[1] != "help") return arguments;
  arguments.erase(arguments.begin() + 1);
  arguments.emplace_back("--help");
  return arguments;
}

std::string subcommandOf(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    if (argument == "--plugin")
      ++i;
    else if (argument.empty() || argument.front() != '-')
      return argument;
  }
  return {};
}

int runCommandLine(int argc, char** argv, const std::vector<Subcommand>& subcommands) {
  CLI::App app{"Lamina: from mesh to deposited layers on printers and robots", "lamina"};
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* refusing, const CLI::Error& error) {
    return messageOf(*refusing, error) + "\nRun with --help for more information.\n";
  });
  app.set_version_flag("--version", "lamina " + laminaVersion(), "Print the version and exit");
  Chosen chosen;
  chosen.format = formatAskedFor({argv + 1, argv + argc});
  const std::string called = subcommandOf(argc, argv);
  addSubcommands(app, chosen, subcommands, standsFirst(called, argc, argv) ? called : std::string());
  // Of the command alone: subcommands that were added after it would have it too.
  app.footer("Options of a subcommand: lamina SUBCOMMAND --help, or lamina help SUBCOMMAND");
  const std::vector<std::string> names = namesOf(app);
  if (!called.empty() && std::find(names.begin(), names.end(), called) == names.end()) {
    const std::string suggestion = suggestionFor(names, called);
    printFailure(
        {ErrorCode::InvalidConfig, "there is no subcommand '" + called + "'" +
                                       (suggestion.empty() ? ";" : suggestion) + " lamina --help lists them"},
        {}, chosen.format);
    return static_cast<int>(CLI::ExitCodes::ExtrasError);
  }
  std::vector<std::string> plugins;
  addPluginOption(app, plugins);
  try {
    app.parse(argc, argv);
    loadPlugins(pluginsOfEnvironment());
    loadPlugins(plugins);
    chosen.run();
    requirePrinted();
    return chosen.exit_code;
  } catch (const CLI::ParseError& error) {
    return refuse(app, error, chosen.format);
  } catch (...) {
    printFailure(currentFailure(), chosen.counts, chosen.format);
    return 1;
  }
}

}  // namespace lamina::cli
