// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/deposition/deposition_settings.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/job/modes/automatic_settings.hpp"
#include "lamina/job/part/copies.hpp"
#include "lamina/job/part/placement.hpp"
#include "lamina/job/plate/plate_settings.hpp"
#include "lamina/job/profiles/capabilities.hpp"
#include "lamina/job/profiles/giving_way.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/orientation/orientation_settings.hpp"
#include "lamina/parameterization/flattening_settings.hpp"
#include "lamina/picture/frame_settings.hpp"
#include "lamina/planning/compensation/compensation_settings.hpp"
#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/planning/flow/flow_settings.hpp"
#include "lamina/planning/hooks/hook_settings.hpp"
#include "lamina/planning/lift/chart_lift.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/runs/bead_run_settings.hpp"
#include "lamina/planning/scan_pass.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/slicing/adapted/adapted_settings.hpp"
#include "lamina/slicing/conformal/conformal_settings.hpp"
#include "lamina/slicing/curved/curved_settings.hpp"
#include "lamina/slicing/height_field/height_field_settings.hpp"
#include "lamina/slicing/multi_direction/direction_settings.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/slicing/volumetric/volumetric_settings.hpp"
#include "lamina/stiffness/stiffness_settings.hpp"
#include "lamina/sweep/sweep_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/trajectory/process_settings.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"
#include "lamina/verification/overhang/overhang_settings.hpp"
#include "lamina/voids/drops/drop_void_settings.hpp"

namespace lamina {

/// Whether a mesh that is open or wrongly oriented is repaired or refused.
enum class RepairPolicy { Repair, Strict };

/// How the part is read.
struct InputSettings {
  MeshUnits units;
  RepairPolicy repair = RepairPolicy::Repair;
  Tessellation tessellation;
  /// Height to which the outlines of an SVG file are extruded; 0 refuses such files.
  double extrude_mm = 0.0;
};

/// Default planning of a job, as filament printers need it: four solid layers at top and bottom, bridges over
/// gaps, and slower walls where they overhang. A default-constructed `PlanSettings` has none of these.
PlanSettings planOfPrinters();
/// Default cooling of a job: each layer takes at least 5 s. A default-constructed `CoolingSettings` demands
/// no time.
CoolingSettings coolingOfPrinters();
/// Default fan of a job: the fan is used. A default-constructed `FanSettings` leaves the fan alone.
FanSettings fanOfPrinters();

/// The settings of all stages from mesh to program.
struct JobSettings {
  InputSettings input;
  Placement placement = Placement::Centre;
  CopySettings copies;
  /// File of regions with settings of their own (`readModifiersFile`); empty for none.
  std::string modifiers;
  PlateSettings plate;
  MachineSettings machine;
  MachineCapabilities capabilities;
  MaterialSettings material;
  SlicingSettings slicing;
  AutomaticSettings automatic;
  AdaptedSettings adapted;
  CurvedSettings curved;
  ConformalSettings conformal;
  HeightFieldSettings height_field;
  VolumetricSettings volumetric;
  DirectionSettings directions;
  FlatteningSettings flattening;
  LiftSettings lifting;
  OrientationSettings orientation;
  CompensationSettings compensation;
  PlanSettings planning = planOfPrinters();
  BeadRunSettings runs;
  FlowSettings flow;
  CoolingSettings cooling = coolingOfPrinters();
  FanSettings fan = fanOfPrinters();
  HookSettings hooks;
  PauseSettings pauses;
  DropVoidSettings drop_voids;
  OverhangSettings overhang;
  ClearanceSettings clearance;
  DepositionSettings deposition;
  SweepSettings sweep;
  StiffnessSettings stiffness;
  MetricsSettings metrics;
  FrameSettings frames;
  ScanSettings scan;
  MotionLimits motion;
  JointPathSettings joints;
  TrajectorySettings trajectory;
  ProcessSettings process;
  ProgramSettings program;
  /// Not a setting: which of the settings above the slicing mode may leave out.
  GivingWay giving_way;
};

/// Adds the keys of all stages. The settings must outlive the schema.
void describe(SettingsSchema& schema, JobSettings& settings);

/// The defaults, overridden by a YAML file and then by `overrides` in their order. What neither of them
/// states follows from the machine (`withMachineDefaults`).
/// @param yaml_path  empty for none
/// @throws InvalidConfig naming key, value and bound (and the file, if it is not YAML); FileError
JobSettings loadJobSettings(const std::string& yaml_path, const std::vector<SettingText>& overrides);

/// Checks the settings by which a part is sliced, wherever they come from.
/// @throws InvalidConfig naming key, value and bound; also if settings contradict the strategy
///   (`requireConsistent`), if the slicing mode does not allow them (such as scans or skirts on inclined
///   layers), if drop_voids.fill is set for beads, or if the machine cannot do what they ask
///   (`requireCapable`)
void validate(const JobSettings& settings);

}  // namespace lamina
