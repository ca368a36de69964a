// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/study/known_points.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {
namespace {

using TextsByKey = std::map<std::string, std::string>;

/// All settings of slicing, as they are written.
TextsByKey settingsOf(const SliceMeasure& slice, const std::vector<SettingText>& overrides) {
  std::vector<SettingText> all = slice.settings;
  all.insert(all.end(), overrides.begin(), overrides.end());
  JobSettings settings = loadJobSettings(slice.config, all);
  SettingsSchema schema;
  describe(schema, settings);
  TextsByKey texts;
  for (SettingText& setting : settingTexts(schema)) texts[setting.key] = std::move(setting.text);
  return texts;
}

TextsByKey textsOf(const std::vector<SettingText>& values) {
  TextsByKey texts;
  for (const SettingText& value : values) texts[value.key] = value.text;
  return texts;
}

class KnownPointsFinder {
 public:
  explicit KnownPointsFinder(const Study& study) : space_(study.variables) {}

  void add(const std::string& name, const TextsByKey& texts) {
    DesignPoint point;
    try {
      for (const Variable& variable : space_) point.push_back(valueOf(variable, texts.at(variable.name)));
    } catch (const InvalidInput& error) {
      found_.left_out.push_back(name + ": " + error.what());
      return;
    }
    const auto isSame = [&](const KnownPoint& known) { return known.point == point; };
    if (std::none_of(found_.points.begin(), found_.points.end(), isSame))
      found_.points.push_back({name, std::move(point)});
  }

  bool isVariable(const std::string& key) const {
    return std::any_of(space_.begin(), space_.end(),
                       [&](const Variable& variable) { return variable.name == key; });
  }

  /// Keys that are no variables, and not as in the study.
  void addBaseline(const std::string& name, const TextsByKey& of_study, const TextsByKey& texts) {
    std::string others;
    for (const auto& [key, text] : texts)
      if (!isVariable(key) && of_study.at(key) != text) others += (others.empty() ? "" : ", ") + key;
    if (others.empty()) return add(name, texts);
    found_.left_out.push_back(name + ": sets " + others + ", no variable of the search");
  }

  KnownPoints found() && { return std::move(found_); }

 private:
  const DesignSpace& space_;
  KnownPoints found_;
};

}  // namespace

KnownPoints knownPointsOf(const Study& study) {
  KnownPointsFinder finder(study);
  if (study.slice) {
    const TextsByKey of_study = settingsOf(*study.slice, {});
    finder.add("defaults", of_study);
    for (const Baseline& baseline : study.slice->baselines)
      finder.addBaseline(baseline.name, of_study, settingsOf(*study.slice, baseline.settings));
  }
  for (const PublishedRow& row : study.published) {
    const TextsByKey texts = textsOf(row.values);
    const bool is_whole =
        std::all_of(study.variables.begin(), study.variables.end(),
                    [&](const Variable& variable) { return texts.count(variable.name) > 0; });
    if (is_whole) finder.add(row.name, texts);
  }
  return std::move(finder).found();
}

}  // namespace lamina
