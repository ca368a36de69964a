// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/setting_probe.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/plain_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

constexpr char kRefused[] = "refused: ";

std::string firstDifference(const std::string& before, const std::string& after) {
  std::size_t at = 0;
  while (at < before.size() && at < after.size() && before[at] == after[at]) ++at;
  return before.substr(at, 40);
}

}  // namespace

SettingTexts settingTexts(const std::string& assignments) {
  SettingTexts texts;
  std::istringstream stream(assignments);
  for (std::string one; std::getline(stream, one, ';');)
    if (!one.empty()) texts.push_back(settingFromAssignment(one));
  return texts;
}

std::string changedKey(const SettingRow& row) { return settingTexts(row.change).front().key; }

template <>
JobSettings settingsWith<JobSettings>(const SettingTexts& set) {
  JobSettings settings = plainSettings();
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : set) schema.set(setting.key, setting.text);
  return settings;
}

std::string numbersText(const std::vector<double>& numbers) {
  std::ostringstream text;
  text.precision(12);
  for (const double number : numbers) text << number << ' ';
  return text.str() + '\n';
}

std::string resultOf(const SettingProbe& probe, const std::string& with, const std::string& change) {
  SettingTexts set = settingTexts(probe.base + ";" + with);
  for (const SettingText& changed : settingTexts(change)) set.push_back(changed);
  try {
    return probe.result(set);
  } catch (const InvalidConfig&) {
    throw;
  } catch (const Error& error) {
    return kRefused + std::string(error.what());
  }
}

bool isRefusal(const std::string& result) { return result.rfind(kRefused, 0) == 0; }

std::string partFile(const std::string& part) {
  static const ScratchFolder folder;
  static std::map<std::string, std::string> files;
  std::string& file = files[part];
  if (!file.empty()) return file;
  std::istringstream words(part);
  std::string name;
  words >> name;
  SettingTexts parameters;
  for (std::string word; words >> word;) parameters.push_back(settingFromAssignment(word));
  file = folder.file(std::to_string(files.size()) + name + ".stl");
  writeStl(file, makePart(name, parameters));
  return file;
}

void expectEffects(const std::vector<SettingProbe>& probes) {
  for (const SettingProbe& probe : probes) {
    std::map<std::string, std::string> before;
    for (const SettingRow& row : probe.rows) {
      const std::string named = probe.name + ": " + row.change + " with '" + row.with + "'";
      try {
        if (before.count(row.with) == 0) before[row.with] = resultOf(probe, row.with, "");
        const std::string& usual = before[row.with];
        EXPECT_FALSE(isRefusal(usual)) << named << " " << usual;
        EXPECT_FALSE(usual.empty()) << named;
        const std::string changed = resultOf(probe, row.with, row.change);
        EXPECT_TRUE(usual != changed) << named << " changes nothing";
        if (usual != changed && std::getenv("LAMINA_SHOW_EFFECTS") != nullptr)
          std::printf("%s: '%s' -> '%s'\n", named.c_str(), firstDifference(usual, changed).c_str(),
                      firstDifference(changed, usual).c_str());
      } catch (const std::exception& error) {
        ADD_FAILURE() << named << " threw " << error.what();
      }
    }
  }
}

}  // namespace lamina::test
