// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "correction_settings.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// A job that was corrected on its way, to be gone on with.
struct RecordedProgram {
  StreamableProgram program;  ///< as it was sent, and as planned from where the record ends
  std::string toolpath_id;
  std::size_t next_planned = 0;  ///< layer that is deposited as planned, and was not reported
};

/// By the record in `corrections.folder`.
/// @throws InvalidConfig if there is no such folder
/// @throws as `correctionFrom` and `programByMaps`
RecordedProgram recordedProgram(const StreamableProgram& planned, const StreamCorrectionSettings& corrections,
                                const StreamSettings& stream);

}  // namespace lamina
