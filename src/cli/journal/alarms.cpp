// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "lamina/cell/alarm_table.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

void printJson() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const AlarmKind& kind : alarmTable())
    rows.push_back({{"id", kind.id},
                    {"category", std::string(1, letterOf(kind.category))},
                    {"lasts", kind.cause == AlarmCause::Condition},
                    {"title", kind.title},
                    {"remedy", kind.remedy}});
  std::printf("%s\n", nlohmann::ordered_json{{"alarms", rows}}.dump(2).c_str());
}

void printText() {
  for (const AlarmKind& kind : alarmTable())
    std::printf("%u %c  %-42s%s\n", static_cast<unsigned>(kind.id), letterOf(kind.category), kind.title,
                kind.remedy);
}

}  // namespace

void addAlarms(CLI::App& app, Chosen& chosen) {
  auto as_csv = std::make_shared<bool>(false);
  CLI::App* alarms = app.add_subcommand("alarms", kAlarmsDescription);
  addJsonFlag(*alarms, chosen);
  alarms->add_flag("--csv", *as_csv, "As rows of id, category, title and remedy, which PLCs import")
      ->excludes(alarms->get_option("--json"));
  alarms->callback([as_csv, &chosen] {
    chosen.run = [as_csv, &chosen] {
      if (*as_csv)
        std::fputs(alarmTableCsv().c_str(), stdout);
      else if (chosen.format == OutputFormat::Json)
        printJson();
      else
        printText();
    };
  });
}

}  // namespace lamina::cli
