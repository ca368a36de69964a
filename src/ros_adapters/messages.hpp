// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lamina's generated messages, in namespace lamina_msgs: roscpp would put them into `lamina`, where the core
// has its own Toolpath, Bead and Setting. Only C++ uses this name; the ROS types are lamina/Toolpath and so
// on. Include this header instead of <lamina/Toolpath.h>.

#define lamina lamina_msgs
#include <lamina/AcknowledgeAlarm.h>
#include <lamina/AlarmReport.h>
#include <lamina/AppliedCorrection.h>
#include <lamina/Bead.h>
#include <lamina/CalibrateFeeder.h>
#include <lamina/CalibrateSensor.h>
#include <lamina/CalibrateTime.h>
#include <lamina/CellAlarms.h>
#include <lamina/CellJob.h>
#include <lamina/ChangeJob.h>
#include <lamina/ChangeQueue.h>
#include <lamina/ComputeStiffnessAction.h>
#include <lamina/CorrectionMap.h>
#include <lamina/DepositionState.h>
#include <lamina/DepositionSummary.h>
#include <lamina/DriveToolpathAction.h>
#include <lamina/EnqueueJob.h>
#include <lamina/FillVoids.h>
#include <lamina/FilledVoid.h>
#include <lamina/FinishMeasuring.h>
#include <lamina/FollowJointTrajectoryAction.h>
#include <lamina/HeaterState.h>
#include <lamina/HostState.h>
#include <lamina/InclineAction.h>
#include <lamina/InclineGcode.h>
#include <lamina/InclineSummary.h>
#include <lamina/JobQueue.h>
#include <lamina/JogState.h>
#include <lamina/JudgePart.h>
#include <lamina/LayerHeight.h>
#include <lamina/LoadProgram.h>
#include <lamina/LoopFigures.h>
#include <lamina/LoopState.h>
#include <lamina/MachineRest.h>
#include <lamina/MachineState.h>
#include <lamina/ManualState.h>
#include <lamina/Measuring.h>
#include <lamina/MoveByHand.h>
#include <lamina/OptimiseAction.h>
#include <lamina/PackmlCommand.h>
#include <lamina/PackmlStatus.h>
#include <lamina/PlcInputs.h>
#include <lamina/PrintProgress.h>
#include <lamina/ProcessReady.h>
#include <lamina/ProcessState.h>
#include <lamina/ProcessTrajectory.h>
#include <lamina/ProcessValue.h>
#include <lamina/ProfileCounts.h>
#include <lamina/ResumePlace.h>
#include <lamina/ResumeStep.h>
#include <lamina/RunStartup.h>
#include <lamina/SetIo.h>
#include <lamina/SetLoop.h>
#include <lamina/SetRemoteAccess.h>
#include <lamina/SetUnitMode.h>
#include <lamina/Setting.h>
#include <lamina/SimulateDepositionAction.h>
#include <lamina/SliceAction.h>
#include <lamina/SliceMesh.h>
#include <lamina/SliceSummary.h>
#include <lamina/StartupStep.h>
#include <lamina/Status.h>
#include <lamina/StreamProgramAction.h>
#include <lamina/Toolpath.h>
#include <lamina/ToolpathEvent.h>
#include <lamina/ToolpathLayer.h>
#include <lamina/ToolpathPath.h>
#include <lamina/TrackingError.h>
#include <lamina/VoidCount.h>
#include <lamina/VoidFillingSummary.h>
#undef lamina
