// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/part_judgement.hpp"

#include <nlohmann/json.hpp>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/journal/execution_log.hpp"
#include "lamina/journal/part_record.hpp"

namespace lamina {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct FoundPart {
  std::int64_t execution = 0;
  PartRow row;
};

FoundPart partOf(CellJournal& journal, std::int64_t job) {
  const ExecutionLog log(journal);
  std::int64_t execution = 0;
  if (job == 0) {
    const auto last = log.withPart(1);
    if (!last.empty()) execution = last.front();
  } else if (const auto row = log.ofJob(job)) {
    execution = row->id;
  }
  const auto part = execution == 0 ? std::nullopt : log.part(execution);
  if (!part)
    throw InvalidInput(job == 0 ? "no part was made yet"
                                : "job " + std::to_string(job) + " has made no part that can be judged");
  return {execution, *part};
}

OrderedJson recordJson(const ArtefactStore& store, const PartRow& part) {
  const std::string text = readFile(store.pathOf(part.record));
  if (sha256Of(text) != part.record.sha256)
    throw InvalidInput("the record of part " + part.serial +
                       " was changed since it was kept: its SHA-256 is " + sha256Of(text) + "; expected " +
                       part.record.sha256);
  OrderedJson json = OrderedJson::parse(text, nullptr, false);
  if (!json.is_object())
    throw InvalidInput("the record of part " + part.serial + " is no JSON object any more");
  return json;
}

void keepJson(CellJournal& journal, ArtefactStore& store, const FoundPart& part, const OrderedJson& json,
              double time_s) {
  PartRow row = part.row;
  row.record = store.keepText(json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n',
                              "record", "record.json");
  ExecutionLog(journal).setPart(part.execution, row, time_s);
}

}  // namespace

JudgedPart judgePart(CellJournal& journal, ArtefactStore& store, const PartJudgement& judgement) {
  const std::string& verdict = judgement.verdict;
  if (verdict != "good" && verdict != "scrap" && verdict != "rework")
    throw InvalidInput("verdict is '" + verdict + "'; expected good, scrap or rework");
  if (judgement.by.empty()) throw InvalidInput("nobody is named who judges the part");
  FoundPart part = partOf(journal, judgement.job);
  JudgedPart judged{part.row.serial, part.row.verdict};
  OrderedJson json = recordJson(store, part.row);
  json["verdict"] = {{"value", verdict},
                     {"by", judgement.by},
                     {"time", judgement.time_s},
                     {"reason", judgement.reason},
                     {"before", judged.before}};
  part.row.verdict = verdict;
  part.row.verdict_by = judgement.by;
  journal.together([&] {
    keepJson(journal, store, part, json, judgement.time_s);
    journal.add(AuditRow{
        judgement.time_s, judgement.by, "", "verdict of " + judged.serial,
        verdict + ", was " + judged.before + (judgement.reason.empty() ? "" : ": " + judgement.reason)});
  });
  return judged;
}

void renewRecord(CellJournal& journal, ArtefactStore& store, std::int64_t execution, double time_s) {
  const auto row = ExecutionLog(journal).part(execution);
  if (!row) return;
  const OrderedJson before = recordJson(store, *row);
  const PartRecord record = partRecord(journal, execution, {row->verdict, time_s, {}});
  OrderedJson json = OrderedJson::parse(record.json);
  for (const char* key : {"verdict", "corrections"})
    if (before.contains(key)) json[key] = before[key];
  store.keepText(record.layers_csv, "layers", "layers.csv");
  keepJson(journal, store, {execution, *row}, json, time_s);
}

}  // namespace lamina
