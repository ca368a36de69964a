// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/utc_time.hpp"
#include "lamina/cell/packml_model.hpp"
#include "lamina/journal/part_record.hpp"
#include "lamina/picture/html.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The command line of `lamina record` as it was typed.
struct RecordArguments {
  std::string folder;
  std::int64_t job = 0;
  std::string html;
  std::string files;
};

std::string utc(const Json& time_s) {
  if (!time_s.is_number()) return "";
  return utcText(time_s.get<double>(), "%Y-%m-%d %H:%M:%S");
}

std::string plain(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string stateName(const Json& number) {
  const auto state = unitState(number.is_number_integer() ? number.get<int>() : 0);
  return state ? toString(*state) : plain(number);
}

/// A table of the record: what stands above it, and its rows, the first of them the names of its columns.
struct RecordTable {
  std::string title;
  std::vector<std::vector<std::string>> rows;
};

std::vector<std::vector<std::string>> csvRows(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row(1);
  for (const char byte : csv) {
    if (byte == ',') {
      row.emplace_back();
    } else if (byte == '\n') {
      rows.push_back(std::move(row));
      row.assign(1, "");
    } else {
      row.back() += byte;
    }
  }
  return rows;
}

RecordTable partTable(const Json& record) {
  const Json& job = record.at("job");
  const Json& execution = record.at("execution");
  return {
      "Part " + plain(record.at("serial")),
      {{"what", "value"},
       {"verdict", plain(record.at("verdict").at("value")) + ", by " + plain(record.at("verdict").at("by"))},
       {"job", plain(job.at("id")) + ' ' + plain(job.at("name"))},
       {"part", plain(job.at("part"))},
       {"digest", plain(job.at("digest"))},
       {"released by", plain(job.at("released_by"))},
       {"machine", plain(record.at("made").at("machine")) + " on " + plain(record.at("made").at("host"))},
       {"Lamina", plain(record.at("made").at("lamina"))},
       {"operator", plain(execution.at("operator"))},
       {"began, UTC", utc(execution.at("started"))},
       {"ended, UTC", utc(execution.at("ended"))},
       {"outcome", plain(execution.at("outcome")) + ' ' + plain(execution.at("reason"))},
       {"lines taken", plain(execution.at("lines_taken"))},
       {"layers",
        plain(record.at("layers").at("count")) + ", measured " + plain(record.at("layers").at("measured"))}}};
}

std::vector<RecordTable> tablesOf(const Json& record, const std::string& layers_csv) {
  std::vector<RecordTable> tables = {partTable(record)};
  RecordTable files{"Files", {{"kind", "name", "bytes", "SHA-256"}}};
  for (const Json& file : record.at("artefacts"))
    files.rows.push_back(
        {plain(file.at("kind")), plain(file.at("name")), plain(file.at("bytes")), plain(file.at("sha256"))});
  if (record.contains("corrections"))
    for (const Json& file : record.at("corrections"))
      files.rows.push_back({plain(file.at("kind")), plain(file.at("name")), plain(file.at("bytes")),
                            plain(file.at("sha256"))});
  tables.push_back(files);
  RecordTable gaps{"Times in which it waited", {{"began", "ended", "after line", "reason"}}};
  for (const Json& gap : record.at("gaps"))
    gaps.rows.push_back(
        {utc(gap.at("began")), utc(gap.at("ended")), plain(gap.at("line")), plain(gap.at("reason"))});
  tables.push_back(gaps);
  RecordTable transitions{"States", {{"time", "from", "to", "by", "reason"}}};
  for (const Json& row : record.at("transitions"))
    transitions.rows.push_back({utc(row.at("time")), stateName(row.at("from")), stateName(row.at("to")),
                                plain(row.at("source")), plain(row.at("reason"))});
  tables.push_back(transitions);
  RecordTable alarms{"Alarms", {{"time", "ID", "category", "message", "acknowledged by", "gone"}}};
  for (const Json& row : record.at("alarms"))
    alarms.rows.push_back({utc(row.at("time")), plain(row.at("id")), plain(row.at("category")),
                           plain(row.at("message")), plain(row.at("acknowledged_by")), utc(row.at("gone"))});
  tables.push_back(alarms);
  RecordTable values{"Values", {{"time", "key", "value", "source"}}};
  for (const Json& row : record.at("setpoints"))
    values.rows.push_back(
        {utc(row.at("time")), plain(row.at("key")), plain(row.at("value")), plain(row.at("source"))});
  tables.push_back(values);
  tables.push_back({"Layers", csvRows(layers_csv)});
  return tables;
}

std::string page(const std::vector<RecordTable>& tables, const std::vector<std::string>& faults) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                     escapedHtml(tables.front().title) +
                     "</title>\n<style>body{font:10pt "
                     "sans-serif;margin:1.5em}table{border-collapse:collapse;margin-bottom:1.5em}"
                     "th,td{border:1px solid #888;padding:2px 6px;text-align:left;overflow-wrap:anywhere}"
                     "tr{break-inside:avoid}</style></head><body>\n";
  html += faults.empty() ? "<p>All digests are right.</p>\n"
                         : "<p><strong>Not to be believed:</strong></p>\n<ul>\n";
  for (const std::string& fault : faults) html += "<li>" + escapedHtml(fault) + "</li>\n";
  if (!faults.empty()) html += "</ul>\n";
  for (const RecordTable& table : tables) {
    if (table.rows.size() < 2) continue;
    html += "<h2>" + escapedHtml(table.title) + "</h2>\n<table>\n";
    const char* cell = "th";
    for (const auto& row : table.rows) {
      html += "<tr>";
      for (const std::string& text : row)
        html += std::string("<") + cell + '>' + escapedHtml(text) + "</" + cell + '>';
      html += "</tr>\n";
      cell = "td";
    }
    html += "</table>\n";
  }
  return html + "</body></html>\n";
}

std::string printed(const std::vector<RecordTable>& tables) {
  std::string text;
  for (const RecordTable& table : tables) {
    if (table.rows.size() < 2) continue;
    text += table.title + '\n';
    for (const auto& row : table.rows) {
      for (const std::string& cell : row) text += "  " + cell;
      text += '\n';
    }
    text += '\n';
  }
  return text;
}

/// Each under its name, as `lamina correct` reads a program and the maps that it was corrected by.
void writeFiles(const ArtefactStore& store, const std::vector<Artefact>& files, const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError("cannot make the folder " + folder + ": " + failure.message());
  for (const Artefact& file : files) {
    // A name is of who put the job into the queue: no path.
    const std::string name = std::filesystem::path(file.name).filename().string();
    if (name.empty() || name == "." || name == "..")
      throw FileError("a file of the record is called '" + file.name + "'; expected a name");
    AtomicFile out(folder + '/' + name);
    out.write(readFile(store.pathOf(file)));
    out.commit();
  }
}

void printRecord(const RecordArguments& arguments, Chosen& chosen) {
  CellJournal journal = CellJournal::read(arguments.folder + "/cell.db");
  const auto store = ArtefactStore::toRead(arguments.folder + "/artefacts");
  const CheckedRecord checked = readRecord(journal, store, arguments.job);
  chosen.exit_code = checked.faults.empty() ? 0 : 1;
  const Json record = Json::parse(checked.record.json, nullptr, false);
  if (!record.is_object())
    throw FileError("the record of job " + std::to_string(arguments.job) +
                    " is no JSON object; it was changed");
  const std::vector<RecordTable> tables = tablesOf(record, checked.record.layers_csv);
  if (!arguments.html.empty()) {
    AtomicFile file(arguments.html);
    file.write(page(tables, checked.faults));
    file.commit();
  }
  if (!arguments.files.empty()) writeFiles(store, checked.files, arguments.files);
  if (chosen.format == OutputFormat::Json) {
    const Json json = {{"record", record}, {"faults", checked.faults}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  std::fputs(printed(tables).c_str(), stdout);
  for (const std::string& fault : checked.faults) std::fprintf(stderr, "lamina: %s\n", fault.c_str());
  if (checked.faults.empty()) std::puts("all digests are right");
}

}  // namespace

void addRecord(CLI::App& app, Chosen& chosen) {
  auto arguments = std::make_shared<RecordArguments>();
  CLI::App* record = app.add_subcommand("record", kRecordDescription);
  record->add_option("folder", arguments->folder, "Folder of the cell's journal (journal.folder)")
      ->required();
  record->add_option("job", arguments->job, "Number of the job")->required();
  record->add_option("--html", arguments->html, "Also write it as a page to print");
  record->add_option(
      "--files", arguments->files,
      "Also write the files of the job, and the maps that it was corrected by, into this folder");
  addJsonFlag(*record, chosen);
  record->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { printRecord(*arguments, chosen); }; });
}

}  // namespace lamina::cli
