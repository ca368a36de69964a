// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

#include "conversions.hpp"
#include "corrected_stream.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "streamer_settings.hpp"

namespace lamina {

/// Converts toolpaths to programs for one machine.
class ToolpathPrograms {
 public:
  ToolpathPrograms(const CartesianMachine& machine, const GcodeStreamerSettings& settings);

  /// @throws InvalidInput if the machine cannot run the toolpath
  StreamableProgram programOf(const MachineToolpath& placed) const;
  /// The program of a plan that continues where another program rests, and its corrections.
  /// @param present  corrector of the previous program
  /// @param layer    layer in front of which the previous program rests
  PlannedProgram programOf(const MachineToolpath& plan, const LayerCorrector& present,
                           std::size_t layer) const;
  /// The program of a toolpath as it is corrected while it is sent.
  /// @throws InvalidConfig if the machine's programs are not in coordinates of the bed
  std::shared_ptr<CorrectedStream> corrected(const StreamableProgram& program,
                                             const MachineToolpath& planned) const;

 private:
  StreamableProgram written(const MachineToolpath& placed, const ProgramSettings& settings) const;

  CartesianMachine machine_;
  GcodeStreamerSettings settings_;
};

}  // namespace lamina
