// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tf/frames.hpp"

/// Names of all topics, services, actions and parameters that nodes share, relative to the namespace in which
/// they run.
namespace lamina::names {

// Topics.
inline constexpr char kToolpath[] = "toolpath";                 ///< lamina/Toolpath, latched
inline constexpr char kToolpathMarkers[] = "toolpath_markers";  ///< visualization_msgs/MarkerArray, latched
inline constexpr char kSourceToolpathMarkers[] =
    "source_toolpath_markers";  ///< visualization_msgs/MarkerArray, latched: of a program before it is
                                ///< inclined
inline constexpr char kOverhangMarkers[] = "overhang_markers";    ///< visualization_msgs/MarkerArray, latched
inline constexpr char kCollisionMarkers[] = "collision_markers";  ///< visualization_msgs/MarkerArray, latched
inline constexpr char kFrameMarkers[] = "frame_markers";          ///< visualization_msgs/MarkerArray, latched
inline constexpr char kRefusalMarkers[] = "refusal_markers";      ///< visualization_msgs/MarkerArray, latched
inline constexpr char kVoidMarkers[] = "void_markers";            ///< visualization_msgs/MarkerArray, latched
inline constexpr char kMachineState[] = "machine_state";          ///< lamina/MachineState, latched
inline constexpr char kPrintProgress[] = "print_progress";        ///< lamina/PrintProgress
inline constexpr char kMachinePosition[] =
    "machine_position";  ///< sensor_msgs/JointState: axes as the machine reports them
inline constexpr char kJointStates[] = "joint_states";          ///< sensor_msgs/JointState
inline constexpr char kJointTrajectory[] = "joint_trajectory";  ///< trajectory_msgs/JointTrajectory
inline constexpr char kCartesianTrajectory[] =
    "cartesian_trajectory";  ///< trajectory_msgs/MultiDOFJointTrajectory, latched: of the nozzle
inline constexpr char kCartesianProcess[] =
    "cartesian_process";  ///< lamina/ProcessTrajectory, latched: what goes with cartesian_trajectory
inline constexpr char kNozzlePath[] = "nozzle_path";                ///< nav_msgs/Path
inline constexpr char kProcessTrajectory[] = "process_trajectory";  ///< lamina/ProcessTrajectory
inline constexpr char kProcessState[] = "process_state";            ///< lamina/ProcessState
inline constexpr char kProcessReady[] = "process_ready";            ///< lamina/ProcessReady
inline constexpr char kTrackingError[] = "tracking_error";          ///< lamina/TrackingError
inline constexpr char kJogTwist[] = "jog_twist";                    ///< geometry_msgs/TwistStamped
inline constexpr char kJogJoints[] = "jog_joints";                  ///< sensor_msgs/JointState
inline constexpr char kJogState[] = "jog_state";                    ///< lamina/JogState, latched
inline constexpr char kManualState[] = "manual_state";              ///< lamina/ManualState, latched
inline constexpr char kSpeedFactor[] = "speed_factor";              ///< std_msgs/Float64
inline constexpr char kPartMarkers[] = "part_markers";    ///< visualization_msgs/MarkerArray, latched
inline constexpr char kCheckMarkers[] = "check_markers";  ///< visualization_msgs/MarkerArray, latched
inline constexpr char kProfile[] = "profile";             ///< sensor_msgs/PointCloud2 of the profile sensor
inline constexpr char kDeposited[] = "deposited";  ///< sensor_msgs/PointCloud2 of the deposited material
inline constexpr char kDepositedMarkers[] = "deposited_markers";  ///< visualization_msgs/MarkerArray, latched
inline constexpr char kDepositionState[] = "deposition_state";    ///< lamina/DepositionState, latched
inline constexpr char kLayerHeight[] = "layer_height";            ///< lamina/LayerHeight
inline constexpr char kCorrection[] = "correction";               ///< lamina/CorrectionMap, latched
inline constexpr char kAppliedCorrection[] = "applied_correction";  ///< lamina/AppliedCorrection
inline constexpr char kReplannedToolpath[] = "replanned_toolpath";  ///< lamina/Toolpath, latched
inline constexpr char kLoopState[] = "loop_state";                  ///< lamina/LoopState, latched
inline constexpr char kLoopFigures[] = "loop_figures";              ///< lamina/LoopFigures, latched
inline constexpr char kLoopCells[] = "loop_cells";                  ///< sensor_msgs/PointCloud2, latched
inline constexpr char kGainMap[] = "gain_map";                      ///< sensor_msgs/PointCloud2, latched
inline constexpr char kDeviationMarkers[] =
    "deviation_markers";                            ///< visualization_msgs/MarkerArray, latched, of the loop
inline constexpr char kMeasuring[] = "measuring";   ///< lamina/Measuring, latched
inline constexpr char kHeightMap[] = "height_map";  ///< sensor_msgs/PointCloud2 of measured heights
inline constexpr char kHeightOctomap[] = "height_octomap";  ///< octomap_msgs/Octomap, if that is installed
inline constexpr char kHeightDeviation[] =
    "height_deviation";  ///< sensor_msgs/Image, 32FC1 [m], measured less expected

inline constexpr char kPrintedLayers[] = "printed_layers";  ///< visualization_msgs/MarkerArray, of the panel
inline constexpr char kShownLayers[] = "shown_layers";      ///< visualization_msgs/MarkerArray, of the panel
inline constexpr char kSourceLayers[] = "source_layers";    ///< visualization_msgs/MarkerArray, of the panel
inline constexpr char kInclinedLayers[] =
    "inclined_layers";  ///< visualization_msgs/MarkerArray, of the panel

inline constexpr char kPackmlStatus[] = "packml_status";  ///< lamina/PackmlStatus, latched
inline constexpr char kAlarms[] = "alarms";               ///< lamina/CellAlarms, latched
inline constexpr char kJobQueue[] = "job_queue";          ///< lamina/JobQueue, latched
inline constexpr char kHostState[] = "host_state";        ///< lamina/HostState, latched
inline constexpr char kPageAddress[] = "page_address";  ///< std_msgs/String, latched: of the operator's page
inline constexpr char kAlarmReports[] = "alarm_reports";  ///< lamina/AlarmReport, of other nodes to the unit
inline constexpr char kPlcInputs[] = "plc_inputs";        ///< lamina/PlcInputs, latched
inline constexpr char kHeaterState[] = "heater_state";    ///< lamina/HeaterState, latched

// Services.
inline constexpr char kSliceMesh[] = "slice_mesh";  ///< lamina/SliceMesh
inline constexpr char kFillVoids[] = "fill_voids";  ///< lamina/FillVoids
inline constexpr char kInclineGcode[] =
    "incline_gcode";                                ///< lamina/InclineGcode, and the action lamina/Incline
inline constexpr char kPause[] = "pause";           ///< std_srvs/Trigger
inline constexpr char kResume[] = "resume";         ///< std_srvs/Trigger
inline constexpr char kAbort[] = "abort";           ///< std_srvs/Trigger
inline constexpr char kChangeJob[] = "change_job";  ///< lamina/ChangeJob
inline constexpr char kResumePlace[] = "resume_place";          ///< lamina/ResumePlace
inline constexpr char kRunStartup[] = "run_startup";            ///< lamina/RunStartup
inline constexpr char kSaveHeightMap[] = "save_height_map";     ///< std_srvs/Trigger
inline constexpr char kReadCalibration[] = "read_calibration";  ///< std_srvs/Trigger
inline constexpr char kCalibrateTime[] = "calibrate_time";      ///< lamina/CalibrateTime
inline constexpr char kCalibrateSensor[] = "calibrate_sensor";  ///< lamina/CalibrateSensor
inline constexpr char kCalibrateFeeder[] = "calibrate_feeder";  ///< lamina/CalibrateFeeder
inline constexpr char kSetLoop[] = "set_loop";                  ///< lamina/SetLoop
inline constexpr char kMachineRest[] = "machine_rest";          ///< lamina/MachineRest
inline constexpr char kFinishMeasuring[] = "finish_measuring";  ///< lamina/FinishMeasuring

inline constexpr char kPackmlCommand[] = "packml_command";        ///< lamina/PackmlCommand
inline constexpr char kSetUnitMode[] = "set_mode";                ///< lamina/SetUnitMode
inline constexpr char kMoveByHand[] = "move_by_hand";             ///< lamina/MoveByHand
inline constexpr char kEnqueueJob[] = "enqueue_job";              ///< lamina/EnqueueJob
inline constexpr char kChangeQueue[] = "change_queue";            ///< lamina/ChangeQueue
inline constexpr char kAcknowledgeAlarm[] = "acknowledge_alarm";  ///< lamina/AcknowledgeAlarm
inline constexpr char kJudgePart[] = "judge_part";                ///< lamina/JudgePart
inline constexpr char kConfirmRemoval[] = "confirm_removal";      ///< std_srvs/Trigger
inline constexpr char kSetRemoteAccess[] = "set_remote_access";   ///< lamina/SetRemoteAccess

// Actions.
inline constexpr char kSlice[] = "slice";                             ///< lamina/Slice
inline constexpr char kStiffnessPoints[] = "stiffness_points";        ///< sensor_msgs/PointCloud2, latched
inline constexpr char kComputeStiffness[] = "compute_stiffness";      ///< lamina/ComputeStiffness
inline constexpr char kSimulateDeposition[] = "simulate_deposition";  ///< lamina/SimulateDeposition
inline constexpr char kOptimise[] = "optimise";                       ///< lamina/Optimise
inline constexpr char kDriveToolpath[] = "drive_toolpath";            ///< lamina/DriveToolpath
inline constexpr char kFollowJointTrajectory[] =
    "follow_joint_trajectory";                              ///< of control_msgs, or of the same fields
inline constexpr char kStreamProgram[] = "stream_program";  ///< lamina/StreamProgram

// Results.
inline constexpr char kNodeEnded[] =
    "the node was ended";  ///< in the message of a job that is CANCELLED by the end of its own node

inline constexpr char kTipOff[] =
    "the nozzle tip is ";  ///< begins the message of a drive that was given up since the tip left its path
inline constexpr char kGoalEnded[] =
    "the controller ended a goal as ";  ///< begins that of one whose controller gave a goal up

// Parameters.
inline constexpr char kPluginsParameter[] = "plugins";  ///< private: paths of plug-ins, colons between
inline constexpr char kDiagnosticPeriodParameter[] =
    "diagnostic_period";  ///< private: of diagnostic_updater, between reports on /diagnostics [s]
inline constexpr char kListeningPortParameter[] = "listening_port";  ///< private, set by plc_link itself

}  // namespace lamina::names
