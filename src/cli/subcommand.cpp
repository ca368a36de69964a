// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "subcommand.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace lamina::cli {
namespace {

nlohmann::ordered_json valueOf(const Setting& setting) {
  const bool is_plain = setting.type == "number" || setting.type == "integer" || setting.type == "flag";
  if (is_plain) return nlohmann::ordered_json::parse(setting.get());
  return setting.get();
}

}  // namespace

void addJsonFlag(CLI::App& subcommand, Chosen& chosen) {
  subcommand.add_flag_callback(
      "--json", [&chosen] { chosen.format = OutputFormat::Json; },
      "Print one JSON object on standard output and nothing else there, also on failure");
}

void printConfig(const SettingsSchema& schema, OutputFormat format) {
  if (format == OutputFormat::Text) {
    std::fputs(settingsToYaml(schema).c_str(), stdout);
    return;
  }
  nlohmann::ordered_json json;
  for (const Setting& setting : schema.settings()) json[setting.key] = valueOf(setting);
  std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace lamina::cli
