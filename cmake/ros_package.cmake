# The catkin side: messages, devel space, and what other packages get.
# Messages for C++ and Python; nobody here speaks the others.
set(ENV{ROS_LANG_DISABLE} "geneus:genlisp:gennodejs")
find_package(catkin REQUIRED COMPONENTS
  actionlib actionlib_msgs diagnostic_msgs diagnostic_updater geometry_msgs kdl_parser message_generation nav_msgs
  rosbag roscpp
  sensor_msgs std_msgs std_srvs tf2 tf2_ros trajectory_msgs visualization_msgs)

add_message_files(FILES
  AlarmReport.msg AppliedCorrection.msg Bead.msg CellAlarm.msg CellAlarms.msg CellJob.msg CorrectionMap.msg CorrectionPath.msg
  DepositionState.msg DepositionSummary.msg FilledVoid.msg HeaterState.msg HostNode.msg HostPeer.msg HostState.msg
  InclineSummary.msg JobQueue.msg JogState.msg JointTolerance.msg LayerHeight.msg LoopFigures.msg LoopState.msg MachineState.msg
  ManualState.msg Measuring.msg PackmlStatus.msg PlcInputs.msg PrintProgress.msg ProcessOutput.msg ProcessPoint.msg ProcessReady.msg ProcessState.msg
  ProcessTrajectory.msg ProcessValue.msg ProfileCounts.msg ResumeStep.msg Setting.msg SliceSummary.msg StartupStep.msg Status.msg Toolpath.msg
  ToolpathEvent.msg ToolpathLayer.msg ToolpathPath.msg TrackingError.msg VoidCount.msg VoidFillingSummary.msg)
add_service_files(FILES
  AcknowledgeAlarm.srv CalibrateFeeder.srv CalibrateSensor.srv CalibrateTime.srv ChangeJob.srv ChangeQueue.srv EnqueueJob.srv
  FillVoids.srv FinishMeasuring.srv InclineGcode.srv JudgePart.srv LoadProgram.srv MachineRest.srv MoveByHand.srv PackmlCommand.srv ResumePlace.srv RunStartup.srv SetIo.srv
  SetLoop.srv SetRemoteAccess.srv SetUnitMode.srv SliceMesh.srv)
add_action_files(FILES ComputeStiffness.action DriveToolpath.action FollowJointTrajectory.action Incline.action Optimise.action SimulateDeposition.action Slice.action
  StreamProgram.action)
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs std_msgs trajectory_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES lamina_core
  CATKIN_DEPENDS actionlib actionlib_msgs diagnostic_msgs diagnostic_updater geometry_msgs kdl_parser message_runtime nav_msgs
    rosbag roscpp sensor_msgs std_msgs std_srvs tf2 tf2_ros trajectory_msgs visualization_msgs
  DEPENDS EIGEN3
  SKIP_PKG_CONFIG_GENERATION)

# Messages in a namespace of their own, for what uses the core as well; where other packages of a workspace find it.
configure_file(src/ros_adapters/messages.hpp ${CATKIN_DEVEL_PREFIX}/include/lamina_ros/messages.hpp COPYONLY)

# A master and nodes on the loopback interface by default, for whoever sources the setup files (docs/cell/security.md). Where those are
# the package's own, install_setup.cmake copies them.
set(hook_options)
if(LAMINA_OWN_SETUP_FILES)
  set(hook_options SKIP_INSTALL)
endif()
catkin_add_env_hooks(50.lamina_loopback SHELLS sh DIRECTORY ${PROJECT_SOURCE_DIR}/deploy ${hook_options})
