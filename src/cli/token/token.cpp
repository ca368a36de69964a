// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/utc_time.hpp"
#include "lamina/web/web_store.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

constexpr double kDay = 86400.0;  // [s]

struct TokenArguments {
  std::string folder;
  std::string name;
  std::string role;
  double days = 0.0;
};

/// @throws FileError if there is no such file: a misspelt folder is not to have one made
std::string existingStore(const std::string& folder) {
  std::string path = folder + "/page.db";
  if (!std::filesystem::exists(path))
    throw FileError(path + ": is not there; expected the folder of operator_page");
  return path;
}

/// The page may not have run yet.
std::string madeStore(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder + ": cannot be made: " + error.message());
  return folder + "/page.db";
}

void addOne(const TokenArguments& arguments) {
  WebStore store(madeStore(arguments.folder));
  NewToken token{arguments.name, webRole(arguments.role), std::nullopt};
  if (arguments.days > 0.0) token.expires_s = utcNow() + arguments.days * kDay;
  const std::string key = store.add(token, utcNow());
  store.add(AuditRow{utcNow(), "this host", "lamina token",
                     "add token '" + token.name + "' as " + toString(token.role), "done"});
  std::printf("%s\n", key.c_str());
  std::fprintf(stderr, "The token of %s. It is shown this once.\n", token.name.c_str());
}

std::string dayOf(const std::optional<double>& utc_s) {
  if (!utc_s) return "never";
  return utcText(*utc_s, "%Y-%m-%d");
}

void list(const TokenArguments& arguments) {
  for (const WebToken& token : WebStore(existingStore(arguments.folder)).tokens())
    std::printf("%s: %s, expires %s, last used %s\n", token.name.c_str(), toString(token.role),
                dayOf(token.expires_s).c_str(), dayOf(token.last_used_s).c_str());
}

void removeOne(const TokenArguments& arguments) {
  WebStore store(existingStore(arguments.folder));
  for (const WebToken& token : store.tokens()) {
    if (token.name != arguments.name) continue;
    store.remove(token.id);
    store.add(AuditRow{utcNow(), "this host", "lamina token", "remove token '" + token.name + "'", "done"});
    return;
  }
  throw InvalidInput("there is no token named '" + arguments.name + "'");
}

}  // namespace

void addToken(CLI::App& app, Chosen& chosen) {
  const auto arguments = std::make_shared<TokenArguments>();
  CLI::App* command = app.add_subcommand("token", kTokenDescription);
  command->require_subcommand(1);
  CLI::App* add = command->add_subcommand("add", "Make a token and print it, once");
  add->add_option("--role", arguments->role, "viewer, sender, operator or maintenance")->required();
  add->add_option("--days", arguments->days, "days until it expires; 0 for never")
      ->check(CLI::Range(0.0, 3650.0));
  CLI::App* remove = command->add_subcommand("remove", "Remove a token; who uses it is logged out");
  for (CLI::App* named : {add, remove})
    named->add_option("--name", arguments->name, "who holds it")->required();
  CLI::App* shown = command->add_subcommand("list", "The tokens that there are");
  for (CLI::App* one : {add, remove, shown})
    one->add_option("FOLDER", arguments->folder, "folder of operator_page (web.folder)")->required();
  add->callback([arguments, &chosen] { chosen.run = [arguments] { addOne(*arguments); }; });
  remove->callback([arguments, &chosen] { chosen.run = [arguments] { removeOne(*arguments); }; });
  shown->callback([arguments, &chosen] { chosen.run = [arguments] { list(*arguments); }; });
}

}  // namespace lamina::cli
