// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "arguments/machine_run.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/kinematics/model/seen_bodies.hpp"
#include "lamina/picture/bead_solid.hpp"
#include "lamina/picture/scene_picture.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

constexpr double kGlowing = 4.0;    // s after which a bead is shown cold
constexpr double kMargin = 0.08;    // of the size of the machine, beside it
constexpr double kCloseSpan = 2.0;  // of the size of the part
constexpr Colour kHot{1.00, 0.42, 0.05};
constexpr Colour kCold{0.50, 0.53, 0.58};
constexpr Colour kColdBetween{0.62, 0.65, 0.70};  // every other layer
constexpr Colour kFloor{0.93, 0.93, 0.92};

struct FilmArguments {
  MachineRunArguments run;
  std::string folder;
  int frames = 8;
  SettingOptions settings;
};

/// One instant of the film.
struct Frame {
  std::string file;
  JointState state;
};

/// In degrees what turns, and the whole turns of what turns without end.
std::string frameValue(const DrivenJoint& joint, double value) {
  char text[64];
  const double turns = std::isfinite(joint.high) ? 0.0 : std::round(value / (2.0 * M_PI));
  const bool is_linear = joint.kind == JointKind::Linear;
  std::snprintf(text, sizeof(text), is_linear ? "%.1f mm" : "%.1f deg",
                is_linear ? value : toDegrees(value - 2.0 * M_PI * turns));
  if (turns == 0.0) return text;
  const long whole = std::lround(turns);
  return std::string(text) + " after " + std::to_string(whole) + (std::abs(whole) == 1 ? " turn" : " turns");
}

/// The links that carry the bed, those that go with it, and the root: all others belong to the head.
std::set<std::string> linksBelowPart(const LinkBodies& bodies) {
  std::set<std::string> below;
  for (std::size_t group = bodies.bed;; group = bodies.groups[group].parent) {
    below.insert(bodies.groups[group].links.begin(), bodies.groups[group].links.end());
    if (bodies.groups[group].joint.empty()) return below;
  }
}

/// The machine with what it has deposited, at any instant of a run.
class Film {
 public:
  Film(const TimedRun& timed, const KinematicModel& model, std::string source)
      : timed_(timed),
        model_(model),
        source_(std::move(source)),
        bodies_(displayBodies(model.urdf())),
        root_(linkBodies(model.urdf()).groups.front().links.front()),
        below_part_(linksBelowPart(linkBodies(model.urdf()))) {
    const auto& at = timed_.run.path.at;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Path& path = pathOf(at[i]);
      if (path.role != PathRole::Travel)
        part_.include(timed_.run.bed_from_part * path.points[at[i].waypoint]);
    }
    const auto links = model_.bedFromLinks(stateAt(0.0).position);
    for (const DisplayBody& body : bodies_)
      for (const Point3& vertex : body.mesh.vertices)
        machine_.include(links.at(root_).inverse() * links.at(body.link) * vertex);
  }

  JointState stateAt(double time_s) const { return timed_.trajectory->at(time_s); }
  double duration() const { return timed_.trajectory->duration(); }

  void draw(const Frame& frame) const {
    const auto links = model_.bedFromLinks(frame.state.position);
    const Eigen::Isometry3d root_from_bed = links.at(root_).inverse();
    ScenePicture picture{model_.name() + " lays " + source_, subtitleOf(frame.state), {}, {}};
    addFloor(picture);
    for (const DisplayBody& body : bodies_) {
      addMoved(picture, body.mesh, root_from_bed * links.at(body.link),
               {body.colour[0], body.colour[1], body.colour[2]});
      picture.solids.back().may_be_glass = below_part_.count(body.link) == 0;
    }
    addBeads(picture, root_from_bed, frame.state.time_s);
    const Point3 size = machine_.high - machine_.low;
    picture.panels.push_back({"the cell", toRadians(-62.0), toRadians(22.0),
                              0.5 * (machine_.low + machine_.high),
                              (1.0 + kMargin) * std::max(size.head<2>().norm(), size.z())});
    const double close = kCloseSpan * std::max((part_.high - part_.low).maxCoeff(), 20.0);
    picture.panels.push_back({"the part, through the head; what was deposited last glows", toRadians(-62.0),
                              toRadians(22.0), root_from_bed * Point3(0.5 * (part_.low + part_.high)), close,
                              true});
    drawScene(picture, frame.file);
  }

  std::string subtitleOf(const JointState& state) const {
    char text[160];
    std::snprintf(text, sizeof(text), "layer %zu of %zu, %.1f s of %.1f s, tip at %.2f mm/s over the part",
                  state.heading_for.layer + 1, timed_.run.toolpath().layers.size(), state.time_s, duration(),
                  state.tip_speed_mm_s);
    std::string subtitle = text;
    for (std::size_t j = 0; j < model_.joints().size(); ++j) {
      const DrivenJoint& joint = model_.joints()[j];
      if (joint.name.rfind("external_", 0) != 0) continue;
      const double value = state.position[static_cast<Eigen::Index>(j)];
      subtitle += ", " + joint.name + " at " + frameValue(joint, value);
    }
    return subtitle;
  }

 private:
  const Path& pathOf(const WaypointIndex& at) const {
    return timed_.run.toolpath().layers[at.layer].paths[at.path];
  }

  void addMoved(ScenePicture& picture, Mesh mesh, const Eigen::Isometry3d& by, const Colour& colour) const {
    for (Point3& vertex : mesh.vertices) vertex = by * vertex;
    picture.solids.push_back({std::move(mesh), colour});
  }

  void addFloor(ScenePicture& picture) const {
    const double z = machine_.low.z();
    const Point3 margin = kMargin * (machine_.high - machine_.low);
    const Point3 low = machine_.low - margin;
    const Point3 high = machine_.high + margin;
    picture.solids.push_back(
        {{{{low.x(), low.y(), z}, {high.x(), low.y(), z}, {high.x(), high.y(), z}, {low.x(), high.y(), z}},
          {{0, 1, 2}, {0, 2, 3}}},
         kFloor});
  }

  /// What was deposited by then, the last of it hot.
  void addBeads(ScenePicture& picture, const Eigen::Isometry3d& root_from_bed, double now) const {
    Mesh hot;
    std::array<Mesh, 2> cold;
    const auto& at = timed_.run.path.at;
    const std::vector<double>& times = timed_.trajectory->stationTimes();
    for (std::size_t i = 1; i < at.size() && times[i - 1] < now; ++i) {
      const Path& path = pathOf(at[i]);
      if (path.role == PathRole::Travel || at[i].layer != at[i - 1].layer || at[i].path != at[i - 1].path)
        continue;
      const Point3& from = path.points[at[i - 1].waypoint];
      const double taken = times[i] - times[i - 1];
      const double share = taken > 0.0 ? std::min(1.0, (now - times[i - 1]) / taken) : 1.0;
      const Point3 to = from + share * (path.points[at[i].waypoint] - from);
      Mesh& laid = now - times[i] < kGlowing ? hot : cold[at[i].layer % 2];
      laid =
          joined(std::move(laid), beadSolid({from, to, path.orientation.at(at[i].waypoint) * Point3::UnitZ(),
                                             path.bead.at(at[i].waypoint)}));
    }
    const Eigen::Isometry3d root_from_part = root_from_bed * timed_.run.bed_from_part;
    addMoved(picture, std::move(cold[0]), root_from_part, kCold);
    addMoved(picture, std::move(cold[1]), root_from_part, kColdBetween);
    addMoved(picture, std::move(hot), root_from_part, kHot);
  }

  const TimedRun& timed_;
  const KinematicModel& model_;
  std::string source_;
  std::vector<DisplayBody> bodies_;
  std::string root_;
  std::set<std::string> below_part_;
  Box3 part_;     // on the bed
  Box3 machine_;  // in the frame of its root, as it begins
};

std::string frameFile(const std::string& folder, int number) {
  char name[24];
  std::snprintf(name, sizeof(name), "frame_%03d.png", number);
  return (std::filesystem::path(folder) / name).string();
}

void film(const FilmArguments& arguments, OutputFormat format) {
  std::error_code fault;
  std::filesystem::create_directories(arguments.folder, fault);
  if (fault)
    throw FileError("'" + arguments.folder + "' cannot be made a folder: " + fault.message() +
                    "; expected a folder for the pictures");
  const JobSettings settings = settingsOnMachine(arguments.settings, arguments.run);
  const auto model = kinematicModelOf(settings.machine);
  TerminalProgress progress;
  const TimedRun timed = inTime(runOfInput(CheckedMachine(*model), arguments.run.input, settings, progress),
                                *model, runSettings(settings).timing);
  const Film film(timed, *model, std::filesystem::path(arguments.run.input).filename().string());
  nlohmann::ordered_json frames = nlohmann::json::array();
  for (int number = 1; number <= arguments.frames; ++number) {
    throwIfCancelled(progress, "draw");
    const Frame frame{frameFile(arguments.folder, number),
                      film.stateAt(film.duration() * number / arguments.frames)};
    film.draw(frame);
    frames.push_back({{"file", frame.file}, {"time_s", frame.state.time_s}});
    if (format == OutputFormat::Text)
      std::printf("%s: %s\n", frame.file.c_str(), film.subtitleOf(frame.state).c_str());
  }
  if (format == OutputFormat::Json)
    std::printf("%s\n",
                nlohmann::ordered_json({{"machine", model->name()}, {"frames", frames}}).dump(2).c_str());
}

}  // namespace

void addFilm(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "film", "Draw a machine or robot and the part that grows on it, at instants of its run");
  const auto arguments = std::make_shared<FilmArguments>();
  addMachineRun(*subcommand, arguments->run);
  subcommand
      ->add_option("--frames", arguments->frames, "Pictures, at even times; the last of the part when done")
      ->check(CLI::Range(1, 999));
  subcommand->add_option("-o,--output", arguments->folder, "Folder for frame_001.png, ...")->required();
  addSettingOptions(*subcommand, arguments->settings, "Settings (YAML) for slicing, reading and the joints");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { film(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
