// The whole job of `lamina slice`, with settings: 02_settings part.gcode [KEY=VALUE...]
//
// It repairs the mesh, places the part on the bed and checks the program against the machine, which 01_slice
// leaves out.
#include <iostream>
#include <lamina/base/error.hpp>
#include <lamina/job/slice_job.hpp>

int main(int count, char** arguments) try {
  if (count < 2) return 2;
  std::vector<lamina::SettingText> settings{{"infill.strategy", "hilbert"}, {"infill.density", "0.3"}};
  for (int i = 2; i < count; ++i) settings.push_back(lamina::settingFromAssignment(arguments[i]));
  lamina::NoProgress progress;
  const lamina::SliceJob job{"blade", arguments[1], lamina::loadJobSettings("", settings)};
  const lamina::SliceSummary summary = lamina::runSliceJob(job, progress).summary;
  std::cout << summary.layers << " layers, " << summary.deposited_mm3 << " mm3, " << summary.estimated_time_s
            << " s\n";
} catch (const lamina::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
