// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "correction_settings.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// A corrected job that is to be resumed.
struct RecordedProgram {
  StreamableProgram program;  ///< as sent up to the end of the record, and as planned from there
  std::string toolpath_id;
  std::size_t next_planned = 0;  ///< next layer deposited as planned that was not reported
};

/// The job by the record in `corrections.folder`.
/// @throws InvalidConfig if there is no such folder
/// @throws as `correctionFrom` and `programByMaps`
RecordedProgram recordedProgram(const StreamableProgram& planned, const StreamCorrectionSettings& corrections,
                                const StreamSettings& stream);

}  // namespace lamina
