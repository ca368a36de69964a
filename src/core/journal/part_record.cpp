// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/part_record.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/base/version.hpp"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRecordVersion = 1;
constexpr std::size_t kDigestDigits = 64;

Json numberOrNull(const std::optional<double>& number) {
  if (number && std::isfinite(*number)) return *number;
  return nullptr;
}

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

void appendCell(std::string& row, const std::optional<double>& value) {
  row += ',';
  if (!value || !std::isfinite(*value)) return;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", *value);
  row += text.data();
}

void appendTime(std::string& row, const std::optional<double>& time_s) {
  row += ',';
  if (!time_s) return;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", *time_s);
  row += text.data();
}

std::string layersCsv(const std::vector<LayerRow>& layers) {
  std::string csv =
      "layer,began,ended,expected_mm,mean_mm,rms_mm,flatness_mm,worst_mm,coverage,gain,nozzle_c,bed_c,"
      "correction\n";
  for (const LayerRow& layer : layers) {
    csv += std::to_string(layer.layer);
    appendTime(csv, layer.began_s);
    appendTime(csv, layer.ended_s);
    for (const auto& value : {layer.expected_mm, layer.mean_mm, layer.rms_mm, layer.flatness_mm,
                              layer.worst_mm, layer.coverage, layer.gain, layer.nozzle_c, layer.bed_c})
      appendCell(csv, value);
    csv += ',' + layer.correction.value_or("") + '\n';
  }
  return csv;
}

Json artefactsJson(const std::vector<Artefact>& all) {
  Json artefacts = Json::array();
  for (const Artefact& artefact : all)
    artefacts.push_back({{"kind", artefact.kind},
                         {"name", artefact.name},
                         {"sha256", artefact.sha256},
                         {"bytes", artefact.bytes}});
  return artefacts;
}

Json executionJson(const ExecutionRow& execution) {
  // Executors that do not measure what they deposit leave it at zero: that is no figure of the part.
  const double material_mm3 = execution.progress.deposited_mm3;
  const Json measured = material_mm3 > 0.0 ? Json(material_mm3) : Json(nullptr);
  return {{"id", execution.id},
          {"attempt", execution.attempt},
          {"started", execution.started_s},
          {"ended", numberOrNull(execution.ended_s)},
          {"outcome", toString(execution.outcome)},
          {"reason", execution.reason},
          {"operator", execution.operator_name},
          {"lines_taken", execution.progress.taken_through},
          {"material_mm3", measured}};
}

Json transitionsJson(const std::vector<TransitionRow>& rows) {
  Json transitions = Json::array();
  for (const TransitionRow& row : rows)
    transitions.push_back({{"time", row.time_s},
                           {"mode", row.mode},
                           {"from", row.from},
                           {"to", row.to},
                           {"command", row.command},
                           {"source", row.source},
                           {"reason", row.reason}});
  return transitions;
}

Json alarmsJson(const std::vector<AlarmRecord>& rows) {
  Json alarms = Json::array();
  for (const AlarmRecord& row : rows)
    alarms.push_back({{"time", row.alarm.time_s},
                      {"id", row.alarm.alarm},
                      {"category", std::string(1, row.alarm.category)},
                      {"value", numberOrNull(row.alarm.value)},
                      {"message", row.alarm.message},
                      {"acknowledged", numberOrNull(row.acknowledged_s)},
                      {"acknowledged_by", row.acknowledged_by},
                      {"gone", numberOrNull(row.gone_s)}});
  return alarms;
}

Json gapsJson(const std::vector<GapRow>& rows) {
  Json gaps = Json::array();
  for (const GapRow& row : rows)
    gaps.push_back({{"began", row.began_s},
                    {"ended", numberOrNull(row.ended_s)},
                    {"line", row.line},
                    {"reason", row.reason}});
  return gaps;
}

Json setpointsJson(const std::vector<SetpointRow>& rows) {
  Json setpoints = Json::array();
  for (const SetpointRow& row : rows)
    setpoints.push_back(
        {{"time", row.time_s}, {"key", row.key}, {"value", row.value}, {"source", row.source}});
  return setpoints;
}

/// Of which program and which execution: no two parts of a journal have the same.
std::string serialOf(const ExecutionRow& execution) {
  return std::to_string(execution.job) + '-' + std::to_string(execution.attempt);
}

/// Whether it can be the name of a kept file, and nothing but that: a changed record may hold any path.
bool isDigest(const std::string& text) {
  return text.size() == kDigestDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string textIn(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Of what is no list of files, none.
std::vector<Artefact> artefactsIn(const Json& json) {
  std::vector<Artefact> artefacts;
  if (!json.is_array()) return artefacts;
  for (const Json& each : json) {
    if (!each.is_object()) continue;
    const auto bytes = each.find("bytes");
    const bool has_size = bytes != each.end() && bytes->is_number_unsigned();
    artefacts.push_back({textIn(each, "sha256"), has_size ? bytes->get<std::uint64_t>() : 0,
                         textIn(each, "kind"), textIn(each, "name")});
  }
  return artefacts;
}

Artefact layersArtefact(const std::string& csv) {
  return {sha256Of(csv), csv.size(), "layers", "layers.csv"};
}

struct CheckedFiles {
  std::vector<Artefact> right;
  std::vector<std::string> faults;
};

CheckedFiles checkFiles(std::vector<Artefact> files, const ArtefactStore& store) {
  CheckedFiles checked;
  checked.right.reserve(files.size());
  for (Artefact& file : files) {
    if (!isDigest(file.sha256))
      checked.faults.push_back(file.name + " has the digest '" + file.sha256 +
                               "'; expected 64 hexadecimal digits");
    else if (!store.torn({file}).empty())
      checked.faults.push_back(file.name + " is gone, or no longer has its digest");
    else
      checked.right.push_back(std::move(file));
  }
  return checked;
}

std::string readOrNothing(const std::string& path) {
  try {
    return readFile(path);
  } catch (const Error&) {
    return "";
  }
}

}  // namespace

PartRecord partRecord(CellJournal& journal, std::int64_t execution, const PartOutcome& end) {
  const ExecutionLog log(journal);
  const ExecutionRow row = log.execution(execution);
  const QueuedJob job = journal.job(row.job);
  const std::vector<LayerRow> layers = log.layers(execution);
  const auto measured = std::count_if(layers.begin(), layers.end(),
                                      [](const LayerRow& layer) { return layer.mean_mm.has_value(); });
  PartRecord record;
  record.layers_csv = layersCsv(layers);
  const Json json = {{"schema", "lamina-part-record"},
                     {"version", kRecordVersion},
                     {"serial", serialOf(row)},
                     {"verdict", {{"value", end.verdict}, {"by", "unit"}}},
                     {"made", {{"host", hostName()}, {"machine", job.machine}, {"lamina", laminaVersion()}}},
                     {"job",
                      {{"id", job.id},
                       {"name", job.name},
                       {"part", job.part},
                       {"digest", job.digest},
                       {"created_by", job.created_by},
                       {"released_by", job.released_by}}},
                     {"artefacts", artefactsJson(job.artefacts)},
                     {"corrections", artefactsJson(end.corrections)},
                     {"execution", executionJson(row)},
                     {"gaps", gapsJson(log.gaps(execution))},
                     {"transitions", transitionsJson(log.transitions(execution))},
                     {"alarms", alarmsJson(log.alarms(execution))},
                     {"setpoints", setpointsJson(log.setpoints(execution))},
                     {"layers",
                      {{"sha256", sha256Of(record.layers_csv)},
                       {"bytes", record.layers_csv.size()},
                       {"count", layers.size()},
                       {"measured", measured}}}};
  record.json = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  return record;
}

void keepRecord(CellJournal& journal, ArtefactStore& store, std::int64_t execution, const PartOutcome& end) {
  const PartRecord record = partRecord(journal, execution, end);
  store.keepText(record.layers_csv, "layers", "layers.csv");
  PartRow part;
  part.serial = serialOf(ExecutionLog(journal).execution(execution));
  part.verdict = end.verdict;
  part.verdict_by = "unit";
  part.record = store.keepText(record.json, "record", "record.json");
  ExecutionLog(journal).setPart(execution, part, end.time_s);
}

CheckedRecord readRecord(CellJournal& journal, const ArtefactStore& store, std::int64_t job) {
  const ExecutionLog log(journal);
  const auto execution = log.ofJob(job);
  const auto part = execution ? log.part(execution->id) : std::nullopt;
  if (!part)
    throw InvalidInput("job " + std::to_string(job) + " has no record: it has not ended, or is not known");
  CheckedRecord checked;
  auto& faults = checked.faults;
  checked.record.json = readFile(store.pathOf(part->record));
  if (sha256Of(checked.record.json) != part->record.sha256)
    faults.push_back("record.json no longer has the digest that the journal keeps: " + part->record.sha256);
  const Json json = Json::parse(checked.record.json, nullptr, false);
  const Json layers = json.is_object() ? json.value("layers", Json::object()) : Json::object();
  const std::string layers_digest = textIn(layers, "sha256");
  if (isDigest(layers_digest))
    checked.record.layers_csv = readOrNothing(store.pathOf({layers_digest, 0, "layers", "layers.csv"}));
  if (layersArtefact(checked.record.layers_csv).sha256 != layers_digest)
    faults.push_back("layers.csv is gone, or no longer has its digest: " + layers_digest);
  const QueuedJob known = journal.job(job);
  std::vector<Artefact> files = known.artefacts;
  const Json corrections = json.is_object() ? json.value("corrections", Json::array()) : Json::array();
  for (Artefact& file : artefactsIn(corrections)) files.push_back(std::move(file));
  CheckedFiles kept = checkFiles(std::move(files), store);
  checked.files = std::move(kept.right);
  faults.insert(faults.end(), kept.faults.begin(), kept.faults.end());
  if (jobDigest(known.artefacts) != known.digest)
    faults.push_back("the files of the job are not those that its digest was made of: " + known.digest);
  if (!json.is_object() || json.value("job", Json::object()).value("digest", "") != known.digest)
    faults.push_back("the record is of another job than the journal's: its digest is not " + known.digest);
  return checked;
}

}  // namespace lamina
