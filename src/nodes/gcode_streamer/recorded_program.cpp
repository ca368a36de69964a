// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_program.hpp"

#include "lamina/base/error.hpp"
#include "lamina/job/corrected_job.hpp"
#include "lamina/streaming/journal/job_journal.hpp"

namespace lamina {

RecordedProgram recordedProgram(const StreamableProgram& planned, const StreamCorrectionSettings& corrections,
                                const StreamSettings& stream) {
  if (corrections.folder.empty())
    throw InvalidConfig(
        "corrections.use is set without corrections.folder, and a job is to be gone on with; expected the "
        "folder with the record of what it was corrected by, or corrections.use false");
  const CorrectionFiles files{corrections.folder, {}};
  const PlannedCorrection correction = correctionFrom(files, corrections.loop, sha256Of(planned));
  const std::size_t next = correction.maps.empty() ? 0 : correction.maps.back().map.layer + 1;
  return {programByMaps(planned, files, correction, stream), correction.planned.id, next};
}

}  // namespace lamina
