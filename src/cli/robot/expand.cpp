// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/description_files/xacro_expansion.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

struct ExpandArguments {
  std::string path;
  std::vector<std::string> values;
  std::vector<std::string> packages;
  std::string output;
};

std::map<std::string, std::string> byName(const std::vector<std::string>& values) {
  std::map<std::string, std::string> named;
  for (const std::string& each : values) {
    const std::size_t colon = each.find(":=");
    if (colon == std::string::npos || colon == 0)
      throw InvalidConfig("argument '" + each + "' is no name:=value");
    named[each.substr(0, colon)] = each.substr(colon + 2);
  }
  return named;
}

}  // namespace

void addExpand(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("expand", "Expand a robot's xacro file into URDF");
  const auto arguments = std::make_shared<ExpandArguments>();
  subcommand->add_option("file", arguments->path, "Xacro file")->required();
  subcommand->add_option("values", arguments->values, "Values of its arguments: name:=value");
  subcommand->add_option("--packages", arguments->packages, "Folder that packages are searched in first");
  subcommand->add_option("-o,--output", arguments->output, "URDF file")->required();
  subcommand->callback([arguments, &chosen] {
    chosen.run = [arguments] {
      writeFile(arguments->output,
                expandXacro(arguments->path, byName(arguments->values), arguments->packages));
    };
  });
}

}  // namespace lamina::cli
