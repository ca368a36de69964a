// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/settings/sliced_text.hpp"

#include <filesystem>
#include <set>

#include "lamina/base/atomic_file.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

std::string writtenTexts(const ScratchFolder& folder, const std::string& suffix) {
  std::set<std::filesystem::path> files;
  const std::filesystem::path of_job(folder.file("job" + suffix));
  for (const auto& entry : std::filesystem::directory_iterator(of_job.parent_path()))
    files.insert(entry.path());
  std::string texts;
  for (const auto& file : files) texts += file.filename().string() + "\n" + readFile(file.string());
  return texts;
}

}  // namespace

SlicedPart slicedBy(const std::string& part, const SettingTexts& set) {
  NoProgress nobody;
  return runSliceJob({partFile(part), "", settingsWith<JobSettings>(set)}, nobody);
}

std::function<std::string(const SettingTexts& set)> toolpathOf(const std::string& part) {
  return [part](const SettingTexts& set) {
    const SlicedPart sliced = slicedBy(part, set);
    std::string text = toolpathId(sliced.toolpath) + "\n";
    text += numbersText({sliced.bed_from_part.translation().x(), sliced.bed_from_part.translation().y(),
                         sliced.summary.deposited_mm3});
    for (const std::string& note : sliced.summary.notes) text += note + "\n";
    return text;
  };
}

std::function<std::string(const SettingTexts& set)> programOf(const std::string& part,
                                                              const std::string& suffix) {
  return [part, suffix](const SettingTexts& set) {
    const ScratchFolder folder;
    NoProgress nobody;
    runSliceJob({partFile(part), folder.file("job" + suffix), settingsWith<JobSettings>(set)}, nobody);
    return writtenTexts(folder, suffix);
  };
}

}  // namespace lamina::test
