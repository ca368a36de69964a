// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs: G-code of three and five axes, RAPID, other languages of robots.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/base/error.hpp"
#include "support/robot_programs.hpp"
#include "support/toolpaths.hpp"

namespace lamina::test {
namespace {

constexpr char kSmall[] =
    "slicing.layer_height_mm=0.5;slicing.first_layer_height_mm=0.5;bead.width_mm=1;skirt.count=0;";
constexpr char kPlate[] = "box x_mm=10 y_mm=6 z_mm=1";

SettingProbe gcodeProbe() {
  return {"G-code",
          kSmall,
          programOf(kPlate, ".gcode"),
          {{"program.filament_diameter_mm=2.85"},
           {"program.dialect=fullcontrol"},
           {"program.flow=1.1"},
           {"program.nozzle_temperature_c=200"},
           {"program.bed_temperature_c=50"},
           {"program.retraction_length_mm=2", "travel.retraction_threshold_mm=0"},
           {"program.retraction_feed_mm_s=20", "travel.retraction_threshold_mm=0"},
           {"program.start_code=G28 X"},
           {"program.end_code=M84"}}};
}

SettingProbe fiveAxisProbe() {
  return {
      "five-axis G-code",
      std::string(kSmall) + "machine.name=five_axis_head_ac;five_axis.use=always;five_axis.dialect=linuxcnc",
      programOf(kPlate, ".gcode"),
      {{"five_axis.use=tilted"},
       {"five_axis.coordinates=joints"},
       {"five_axis.dialect=fanuc"},
       {"five_axis.program_number=7", "five_axis.dialect=fanuc"},
       {"five_axis.program_name=BLADE", "five_axis.dialect=fanuc"},
       {"five_axis.turns=modulo", "five_axis.dialect=fanuc;machine.name=five_axis_table_ac"},
       {"five_axis.extrusion=V"},
       {"five_axis.tip_control_on=G43.4 H1"},
       {"five_axis.tip_control_off=G49 H0"},
       {"five_axis.before_tip_control_off=G91 G28 Z0"},
       {"five_axis.retract_mm=3"},
       {"five_axis.chord_tolerance_mm=0.0005",
        "five_axis.coordinates=joints;orientation.lead_deg=20;joints.max_step_mm=100;"
        "joints.max_step_deg=90"}}};
}

SettingProbe rapidNamesProbe() {
  return {"names in RAPID",
          std::string(kSmall) + "machine.name=irb_4600;rapid.variant=powder_5_axes",
          programOf(kPlate, ".mod"),
          {{"rapid.variant=wire_3_axes"},
           {"rapid.module=plate"},
           {"rapid.procedure=lay"},
           {"rapid.tool=t_head"},
           {"rapid.work_object=w_table"},
           {"rapid.start_point=origin", "rapid.variant=powder_3_axes"},
           {"rapid.offset=way_", "rapid.variant=powder_3_axes"},
           {"rapid.deposition_speed=v_lay"},
           {"rapid.air_speed=v_air"},
           {"rapid.zone=z1"},
           {"rapid.end_zone=z5"},
           {"rapid.laser_on=Beam_ON"},
           {"rapid.laser_off=Beam_OFF"},
           {"rapid.laser_signal=AskLaser"},
           {"rapid.laser_ready_signal=Ready", "rapid.variant=wire_3_axes"},
           {"rapid.wire_signal=AskWire", "rapid.variant=wire_3_axes"},
           {"rapid.powder_signal=AskPowder"},
           {"rapid.gas_signal=AskGas"},
           {"rapid.wire_trigger=StopWire", "rapid.variant=wire_3_axes"},
           {"rapid.aliases=SolicitudGas=doGas"}}};
}

SettingProbe rapidValuesProbe() {
  return {"values in RAPID",
          std::string(kSmall) + "machine.name=irb_4600;rapid.variant=powder_5_axes",
          programOf(kPlate, ".mod"),
          {{"rapid.declare_cell=false"},
           {"rapid.tool_frame=0,0,10,1,0,0,0"},
           {"rapid.tool_centre_of_gravity_mm=0,0,2"},
           {"rapid.tool_mass_kg=2"},
           {"rapid.work_object_frame=0,0,10,1,0,0,0"},
           {"rapid.positioner=STN1"},
           {"rapid.approach_mm=20"},
           {"rapid.start_point_mm=1,2,3", "rapid.variant=powder_3_axes"},
           {"rapid.configuration=joints"},
           {"rapid.fixed_configuration=0,0,1,0"},
           {"rapid.external_axis=5"},
           {"rapid.external_axes=external_1=eax_b", "machine.name=irb_4600_turntable"},
           {"rapid.thesis_compat=true"},
           {"rapid.zone_mm=1", "rapid.zone=mine"},
           {"rapid.turn_speed_deg_s=300"},
           {"rapid.powder_wait_s=2"},
           {"rapid.laser_off_wait_s=2"},
           {"rapid.wire_lead_s=1", "rapid.variant=wire_3_axes"},
           {"rapid.laser_lead_s=1", "rapid.variant=wire_3_axes"},
           {"rapid.layer_wait_s=2", "rapid.variant=wire_3_axes"},
           {"rapid.wire_stop_s=0.3", "rapid.variant=wire_3_axes"},
           {"rapid.max_points=20"},
           {"rapid.loading=in_turn", "rapid.max_points=20"},
           {"rapid.process=arc"},
           {"rapid.levels=laser_power_w=aoLaser*0.001"},
           {"rapid.dry_flag=true"},
           {"rapid.dry_speed_percent=20", "rapid.dry_flag=true"},
           {"rapid.seam_data=seam2", "rapid.process=arc"},
           {"rapid.weld_data=weld2", "rapid.process=arc"},
           {"rapid.weave_data=weave1", "rapid.process=arc"}}};
}

/// Of all that the plate's program lays.
constexpr char kAtOneSpeed[] =
    "robot_program.process=schedules;robot_program.start_schedule=1;robot_program.end_schedule=1;"
    "feed.outer_wall_mm_s=20;feed.inner_wall_mm_s=20;feed.infill_mm_s=20;"
    "feed.skin_mm_s=20;feed.top_skin_mm_s=20;feed.skirt_mm_s=20";

/// Of arcs that start and end by a schedule.
constexpr char kByArc[] =
    "robot_program.process=schedules;robot_program.start_schedule=1;robot_program.end_schedule=1";

/// Mass and centre are set together.
constexpr char kLoaded[] = "robot_program.tool_mass_kg=1;robot_program.tool_centre_of_gravity_mm=0,0,50";

SettingProbe robotProbe(const char* name, const std::string& suffix, std::vector<SettingRow> rows) {
  return {name, std::string(kSmall) + "machine.name=irb_4600", programOf(kPlate, suffix), std::move(rows)};
}

SettingProbe fanucProbe() {
  return robotProbe(
      "Fanuc TP", ".ls",
      {{"robot_program.date=2026-01-31"},
       {"robot_program.process=schedules", "robot_program.start_schedule=1;robot_program.end_schedule=1"},
       {"robot_program.start_schedule=2", kByArc},
       {"robot_program.end_schedule=2", kByArc},
       {"robot_program.weave_schedule=2", kByArc},
       {"fanuc.cnt=50"},
       {"fanuc.joint_3_from_2=0"},
       {"fanuc.flip=negative"},
       {"fanuc.turn_axes=1,4"},
       {"fanuc.payload=2"},
       {"fanuc.arc_equipment=2", kByArc},
       {"fanuc.weld_speed=schedule", kAtOneSpeed},
       {"fanuc.max_lines=100", "robot_program.allow_cut=true"}});
}

SettingProbe tableListingProbe() {
  return {"a listing over a table that turns",
          std::string(kSmall) + "machine.name=irb_4600_turntable;joints.external=follow",
          programOf(kPlate, ".ls"),
          {{"fanuc.coordinated=false", "joints.external=held"},
           {"fanuc.positioner_frame=2"},
           {"fanuc.positioner_tool=2"},
           {"robot_program.external_axes=external_1=-e1+90"}}};
}

SettingProbe tableJobProbe() {
  return {"a job over a table that turns",
          std::string(kSmall) +
              "machine.name=irb_4600_turntable;joints.external=follow;inform.external_pulses=1000;"
              "inform.pulses_per_deg=1000,1000,1000,500,500,250",
          programOf(kPlate, ".jbi"),
          {{"inform.external_pulses=500"}, {"inform.coordinated=false", "joints.external=held"}}};
}

std::vector<SettingProbe> robotProbes() {
  return {robotProbe("KRL", ".src",
                     {{"robot_program.name=plate"},
                      {"robot_program.tool_number=2"},
                      {"robot_program.tool_mass_kg=2", kLoaded},
                      {"robot_program.tool_centre_of_gravity_mm=0,0,80", kLoaded},
                      {"robot_program.frame_number=2"},
                      {"robot_program.approach_mm=20"},
                      {"robot_program.corner_mm=1"},
                      {"robot_program.joint_speed_percent=20"},
                      {"robot_program.dry_flag=3"},
                      {"robot_program.dry_speed_percent=20", "robot_program.dry_flag=3"},
                      {"robot_program.process_output=2"},
                      {"robot_program.process_lead_s=1"},
                      {"robot_program.process_end_s=1"},
                      {"robot_program.levels=laser_power_w=1*0.001"},
                      {"robot_program.joint_signs=1,1,-1,1,1,1"},
                      {"robot_program.joint_zeros_deg=0,-90,90,0,0,0"},
                      {"krl.arc_on=ARC({schedule})",
                       "krl.arc_on=ON();krl.arc_off=OFF();robot_program.process=schedules;"
                       "robot_program.start_schedule=1;robot_program.end_schedule=1"},
                      {"krl.arc_off=OFF({schedule})",
                       "krl.arc_on=ON();krl.arc_off=OFF();robot_program.process=schedules;"
                       "robot_program.start_schedule=1;robot_program.end_schedule=1"},
                      {"krl.points=dat"},
                      {"krl.advance=3"},
                      {"krl.turn_speed_deg_s=100"},
                      {"krl.acceleration_m_s2=1"},
                      {"krl.max_lines=100", "robot_program.allow_cut=true"}}),
          robotProbe("URScript", ".script",
                     {{"urscript.bead_move=movel"},
                      {"urscript.acceleration_m_s2=1"},
                      {"urscript.joint_acceleration_rad_s2=1"},
                      {"urscript.max_points=10", "robot_program.allow_cut=true"}}),
          fanucProbe(),
          tableListingProbe(),
          tableJobProbe(),
          robotProbe("INFORM", ".jbi",
                     {{"inform.speed_unit=cm_min"},
                      {"inform.corner_level=2"},
                      {"inform.pulses_per_deg=1000,1000,1000,500,500,500"},
                      {"inform.flip=negative"},
                      {"inform.rconf_order=front_elbow_flip"},
                      {"inform.rconf_length=24"},
                      {"inform.frame_mark=three"},
                      {"inform.max_points=10", "robot_program.allow_cut=true"}})};
}

/// A program of two layers, so many times; or why there is none.
SettingProbe layersProbe(RobotLanguage language, int times, std::vector<SettingRow> rows) {
  const auto written = [language, times](const SettingTexts& set) {
    Toolpath toolpath;
    for (int i = 0; i < times; ++i)
      for (const ToolpathLayer& layer : twoLayers().layers) toolpath.layers.push_back(layer);
    std::string text;
    try {
      for (const RobotFile& file :
           robotFiles(language, toolpath, settingsWith<JobSettings>(set).program.robot))
        text += file.name + "\n" + file.text;
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return text;
  };
  return {std::string("layers in ") + toString(language), "", written, std::move(rows)};
}

std::vector<SettingProbe> layersProbes() {
  return {
      layersProbe(RobotLanguage::Krl, 200, {{"krl.max_mb=0.1"}}),
      layersProbe(RobotLanguage::UrScript, 1, {{"robot_program.allow_cut=true", "urscript.max_points=4"}}),
      layersProbe(RobotLanguage::Fanuc, 1, {{"fanuc.name_length=8"}}),
      layersProbe(RobotLanguage::Inform, 1, {{"inform.name_length=8"}})};
}

}  // namespace

std::vector<SettingProbe> programProbes() {
  std::vector<SettingProbe> probes = {gcodeProbe(), fiveAxisProbe(), rapidNamesProbe(), rapidValuesProbe()};
  for (SettingProbe& probe : layersProbes()) probes.push_back(std::move(probe));
  for (SettingProbe& probe : robotProbes()) probes.push_back(std::move(probe));
  return probes;
}

}  // namespace lamina::test
