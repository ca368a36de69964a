// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What nodes do after a time: give up scans, hold what arrives, copy their journals.
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/journal/journal_copies.hpp"
#include "nodes/cell_controller/cell_settings.hpp"
#include "nodes/cell_controller/unanswered_order.hpp"
#include "nodes/height_controller/arrival_hold.hpp"
#include "nodes/height_controller/height_controller_settings.hpp"
#include "nodes/layer_height_monitor/monitor_settings.hpp"
#include "nodes/layer_height_monitor/silence_watch.hpp"
#include "ros/settings/node_probes.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

/// When a scan is given up of which no profile comes.
std::string scanGivenUp(const SettingTexts& set) {
  SilenceWatch watch(settingsWith<LayerHeightMonitorSettings>(set).silence_s);
  int looks = 0;
  while (looks < 6000 && !watch.look(7, 0.1 * looks)) ++looks;
  return std::to_string(looks);
}

/// When what arrives at 1 s is used.
std::string usedAt(const SettingTexts& set) {
  ArrivalHold hold(settingsWith<HeightControllerSettings>(set).arrival_hold_s);
  bool is_used = false;
  hold.add(1.0, [&] { is_used = true; });
  double now_s = 1.0;
  for (; now_s < 20.0 && !is_used; now_s += 0.01) hold.release(now_s);
  return numbersText({now_s});
}

/// The copy that is due at 6:00 of a day, and what is left of the copies of five days.
std::string copied(const SettingTexts& set) {
  const JournalCopySettings settings = settingsWith<CellControllerSettings>(set).care.copies;
  const ScratchFolder scratch;
  const std::string folder = scratch.file("cell");
  std::filesystem::create_directory(folder);
  writeFile(folder + "/cell.db", "");
  std::string text = copyDue(folder, 86400.0 * 20000 + 3600.0 * 6, settings);
  for (int day = 1; day <= 5; ++day)
    copyJournal(folder, "copies/cell-2026-11-0" + std::to_string(day) + ".db", settings.kept);
  for (int day = 1; day <= 5; ++day)
    text += std::filesystem::exists(folder + "/copies/cell-2026-11-0" + std::to_string(day) + ".db")
                ? " kept"
                : " gone";
  return text;
}

/// When an order is told of that an executor does not answer, after one that it has answered.
std::string unanswered(const SettingTexts& set) {
  const double patience_s = settingsWith<CellControllerSettings>(set).patience_s;
  UnansweredOrder order;
  order.give("pause", 1.0);
  order.answer("pause");
  std::string text = order.take(100.0, patience_s);
  order.give("abort", 101.0);
  for (double now_s = 101.0; now_s < 200.0; now_s += 0.125) {
    const std::string told = order.take(now_s, patience_s);
    if (!told.empty()) text += told + " at " + numbersText({now_s});
  }
  return text;
}

/// Which reactions to an alarm hold the print.
std::string holding(const SettingTexts& set) {
  std::string text;
  for (const LoopReaction reaction : {LoopReaction::Warn, LoopReaction::Hold, LoopReaction::Replan}) {
    RaisedAlarm alarm;
    alarm.reaction = reaction;
    text += holdsPrint(alarm, settingsWith<HeightControllerSettings>(set)) ? "holds " : "goes on ";
  }
  return text;
}

/// What the queue does once a part is complete.
std::string advance(const SettingTexts& set) {
  UnitStatus unit;
  unit.state = UnitState::Complete;
  const auto command = QueueFollower(settingsWith<CellControllerSettings>(set).advance).observe(unit);
  return command ? toString(*command) : "waits for a person";
}

}  // namespace

std::vector<SettingProbe> watchProbes() {
  return {{"a scan that shows nothing", "", scanGivenUp, {{"silence_s=3"}}},
          {"what arrives", "", usedAt, {{"arrival_hold_s=1"}}},
          {"an alarm of the loop on heights", "", holding, {{"pauses_print=false"}, {"plans_followed=true"}}},
          {"an order that is not answered", "", unanswered, {{"executor.patience_s=5"}}},
          {"a part that is complete", "", advance, {{"queue.advance=automatic"}}},
          {"a journal that is copied", "", copied, {{"journal.copy_hour=12"}, {"journal.copies_kept=2"}}}};
}

}  // namespace lamina::test
