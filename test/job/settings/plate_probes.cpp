// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Several parts on one bed, and regions of a part with settings of their own.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/job/plate/plate_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

std::string plated(const SettingTexts& set) {
  NoProgress nobody;
  PlateJob job;
  job.plate = plateOf({partFile("box x_mm=8 y_mm=6 z_mm=1"), partFile("cone radius_mm=5 height_mm=1"),
                       partFile("box x_mm=20 y_mm=6 z_mm=1")});
  job.settings = settingsWith<JobSettings>(set);
  return toolpathId(runPlateJob(job, nobody).sliced.toolpath);
}

std::string modified(const SettingTexts& set) {
  static const ScratchFolder folder;
  const std::string file = folder.file("dense.yaml");
  AtomicFile written(file);
  written.write("modifiers:\n  - {from_mm: 0.5, to_mm: 1, settings: {infill.density: 0.9}}\n");
  written.commit();
  SettingTexts named = set;
  for (SettingText& setting : named)
    if (setting.text == "dense.yaml") setting.text = file;
  return toolpathOf("box x_mm=12 y_mm=10 z_mm=2")(named);
}

}  // namespace

std::vector<SettingProbe> plateProbes() {
  return {{"a plate",
           "",
           plated,
           {{"plate.arrange=pack"},
            {"plate.spacing_mm=8"},
            {"plate.order=by_part"},
            {"plate.labels=m486"},
            {"plate.labels=exclude_object", "program.dialect=klipper"}}},
          {"a part with modifiers", "", modified, {{"part.modifiers=dense.yaml"}}}};
}

}  // namespace lamina::test
