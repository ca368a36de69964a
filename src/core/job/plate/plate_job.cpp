// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/plate/plate_job.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <utility>

#include "job/laps.hpp"
#include "job/modes/inclined_layers.hpp"
#include "job/modes/oriented_planning.hpp"
#include "job/modes/part_slicing.hpp"
#include "job/part/part_reading.hpp"
#include "job/part/shrinkage.hpp"
#include "job/plate/aids_apart.hpp"
#include "job/plate/arrangement.hpp"
#include "job/plate/head_clearance.hpp"
#include "job/plate/laid_beside.hpp"
#include "job/plate/plate_overlap.hpp"
#include "job/plate/plate_toolpath.hpp"
#include "job/plate/plate_tower.hpp"
#include "job/slice_run.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/convex_hull.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/part/copies.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "planning/planned_aids.hpp"
#include "planning/tools/tool_order.hpp"

namespace lamina {
namespace {

/// A part or copy on its way from the request to the plate.
struct PlateItem {
  PlatePart part;
  std::string name;                    ///< no two alike
  JobSettings settings;                ///< with its own
  const SourcePart* source = nullptr;  ///< as read
  Mesh mesh;                           ///< standing; its box over the origin
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Eigen::Affine3d part_from_file = Eigen::Affine3d::Identity();
  PlatePlace place;
  std::optional<Box2> bed_around = std::nullopt;  ///< from its origin, where this ends its brim
};

void requirePlateSettings(const JobSettings& settings) {
  const std::string& mode = settings.slicing.mode;
  if (!hasPlaneLayers(mode))
    throw InvalidConfig("slicing.mode is '" + mode +
                        "'; parts of a plate are sliced in plane layers: expected 'planar' or 'inclined'");
  if (settings.copies.count != 1)
    throw InvalidConfig("part.copies is " + std::to_string(settings.copies.count) +
                        "; expected 1: parts of a plate have 'copies' of their own");
  if (settings.scan.every_layers != 0)
    throw InvalidConfig("scan.every_layers is " + std::to_string(settings.scan.every_layers) +
                        "; expected 0: plates are not scanned");
  if (settings.drop_voids.is_on)
    throw InvalidConfig("drop_voids.fill is true; expected false: plates keep their voids between drops");
  const PlanSettings& planning = settings.planning;
  if (!planning.tools.purge_mm3.empty() && settings.plate.order == PlateOrder::ByPart)
    throw InvalidConfig("tools.purge_mm3 is " + numberText(planning.tools.purge_mm3.front()) +
                        " mm3 with plate.order by_part; expected by_layer: one tower stands beside all");
  if (planning.skirt.layers != 1)
    throw InvalidConfig("skirt.layers is " + std::to_string(planning.skirt.layers) +
                        "; expected 1: the skirt of a plate stands in its first layer");
}

bool isInclined(const JobSettings& settings) { return settings.slicing.plane.angle_deg != 0.0; }

bool hasBelt(const BuildSpace& space) {
  return std::find(space.is_endless.begin(), space.is_endless.end(), true) != space.is_endless.end();
}

/// Finished parts would lie in the planes of those to come, and a tower stands on level layers.
void requireInclinable(const JobSettings& settings) {
  if (!isInclined(settings)) return;
  if (settings.plate.order == PlateOrder::ByPart)
    throw InvalidConfig(
        "plate.order is by_part in inclined layers, on a machine without a belt; expected by_layer");
  const std::vector<double>& purge_mm3 = settings.planning.tools.purge_mm3;
  if (!purge_mm3.empty())
    throw InvalidConfig(
        "tools.purge_mm3 is " + numberText(purge_mm3.front()) +
        " mm3 for a plate in inclined layers; expected none: a prime tower stands on level ones");
}

/// Where parts stand beside each other, a brim along the feet of one's layers may reach the layers of
/// another.
void requireNoFootBrims(const std::vector<PlateItem>& items) {
  if (items.size() < 2) return;
  for (const PlateItem& item : items) {
    const double brim_mm = item.settings.planning.adhesion.brim.width_mm;
    if (isInclined(item.settings) && brim_mm > 0.0)
      throw InvalidConfig("brim.width_mm is " + numberText(brim_mm) + " for part '" + item.name +
                          "' of a plate in inclined layers, on a machine without a belt; expected 0: it is "
                          "not compared with the parts beside it");
  }
}

/// On a belt parts follow each other as they are given.
void requireBeltSettings(const JobSettings& settings, const Plate& plate) {
  const std::vector<double>& purge_mm3 = settings.planning.tools.purge_mm3;
  if (!purge_mm3.empty())
    throw InvalidConfig("tools.purge_mm3 is " + numberText(purge_mm3.front()) +
                        " mm3 with slicing.plane.angle_deg " + numberText(settings.slicing.plane.angle_deg) +
                        "; expected none: a prime tower stands on level layers");
  for (const PlatePart& part : plate.parts)
    if (part.at_mm)
      throw InvalidConfig("part '" + part.file +
                          "' has at_mm in inclined layers; expected none: parts of a belt follow each other");
}

/// A vase rises by itself from layer to layer.
void requireMergeable(const std::vector<PlateItem>& items, PlateOrder order) {
  if (items.size() < 2 || order == PlateOrder::ByPart) return;
  for (const PlateItem& item : items) {
    const std::string& strategy = item.settings.planning.infill.strategy;
    if (infillStrategy(strategy).link != LayerLink::Travel)
      throw InvalidConfig("part '" + item.name + "' has infill.strategy '" + strategy +
                          "', which goes on from layer to layer; expected plate.order by_part");
  }
}

JobSettings settingsOf(const PlatePart& part, const JobSettings& of_plate) {
  JobSettings settings = of_plate;
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : part.settings) {
    requirePartSetting(setting, part.file);
    schema.set(setting.key, setting.text);
  }
  settings.placement = Placement::Centre;
  // Those of a plate lie round all of its parts.
  settings.planning.skirt.count = 0;
  settings.planning.adhesion.prime.line = PrimeLine::None;
  validate(settings);
  settings.planning.tools.purge_mm3.clear();
  settings.planning.tools.purge_into_infill = false;
  return settings;
}

/// Each file once.
class Sources {
 public:
  Sources(const InputSettings& input, Progress& progress) : input_(input), progress_(progress) {}

  const std::vector<SourceObject>& of(const PlatePart& part) {
    const auto known = sources_.find(part.file);
    if (known != sources_.end()) return known->second;
    return sources_.emplace(part.file, readParts(part.file, input_, progress_)).first->second;
  }

 private:
  InputSettings input_;
  Progress& progress_;
  std::map<std::string, std::vector<SourceObject>> sources_;
};

/// An object of the part's file, without a number.
PlateItem itemOf(const PlatePart& part, const SourceObject& object) {
  PlateItem item;
  item.part = part;
  item.source = &object.source;
  item.name = !part.name.empty()     ? part.name
              : !object.name.empty() ? object.name
                                     : std::filesystem::path(part.file).stem().string();
  return item;
}

/// Parts of one name are numbered.
void number(std::vector<PlateItem>& items) {
  std::map<std::string, int> counts;
  for (const PlateItem& item : items) ++counts[item.name];
  std::map<std::string, int> used;
  for (PlateItem& item : items) {
    const std::string stem = item.name;
    if (counts[stem] < 2) continue;
    do item.name = stem + " " + std::to_string(++used[stem]);
    while (counts.count(item.name) > 0);
  }
}

std::vector<PlateItem> itemsOf(const Plate& plate, Sources& sources, const JobSettings& settings) {
  std::vector<PlateItem> items;
  for (const PlatePart& part : plate.parts) {
    const std::vector<SourceObject>& objects = sources.of(part);
    if (part.at_mm && objects.size() > 1)
      throw InvalidConfig("part '" + part.file + "' has at_mm and " + std::to_string(objects.size()) +
                          " objects; expected one, or no place");
    for (const SourceObject& object : objects) {
      PlateItem item = itemOf(part, object);
      try {
        item.settings = settingsOf(part, settings);
      } catch (...) {
        rethrowAt("part '" + item.name + "'");
      }
      items.insert(items.end(), static_cast<std::size_t>(part.copies), item);
    }
  }
  number(items);
  return items;
}

void stand(PlateItem& item) {
  item.part_from_file = standing(item.source->mesh, item.turn, item.part.scale);
  item.mesh = transformed(item.source->mesh, item.part_from_file);
}

/// Middle of the box of a part where its file has it, turned and scaled.
Point2 placeInFile(const PlateItem& item) { return -item.part_from_file.translation().head<2>(); }

Polygon hullOf(const Mesh& mesh) {
  std::vector<Point2> points;
  points.reserve(mesh.vertices.size());
  for (const Point3& vertex : mesh.vertices) points.emplace_back(vertex.head<2>());
  return convexHull(std::move(points));
}

/// As it is deposited: larger where it shrinks afterwards.
Mesh depositedMesh(const PlateItem& item) {
  SourcePart source;
  source.mesh = item.mesh;
  return grownForShrinkage(std::move(source), item.settings).mesh;
}

Polygon footprintOf(const PlateItem& item) {
  return hullOf(changesSize(item.settings.compensation) ? depositedMesh(item) : item.mesh);
}

std::vector<TowerNeighbour> towerNeighbours(const std::vector<PlateItem>& items) {
  std::vector<TowerNeighbour> parts;
  parts.reserve(items.size());
  for (const PlateItem& item : items) parts.push_back({item.name, &item.settings});
  return parts;
}

/// Of the tools at work on a part.
std::vector<Point3> nozzlesFor(const PlanSettings& planning) {
  const std::vector<Point3> offsets_mm = toolOffsets(planning.tools);
  std::vector<Point3> nozzles_mm;
  for (const std::uint32_t tool : toolsAtWork(planning))
    if (tool < offsets_mm.size()) nozzles_mm.push_back(offsets_mm[tool]);
  return nozzles_mm;
}

/// Of the bed, what the tips of all tools at work reach.
Box2 commonReach(const std::vector<PlateItem>& items, const Box3& space, const JobSettings& settings) {
  Box2 common{space.low.head<2>(), space.high.head<2>()};
  const auto include = [&](const PlanSettings& planning) {
    for (const Point3& nozzle : nozzlesFor(planning)) {
      const Point2 offset = nozzle.head<2>();
      common.low = common.low.cwiseMax(space.low.head<2>() + offset);
      common.high = common.high.cwiseMin(space.high.head<2>() + offset);
    }
  };
  include(settings.planning);
  for (const PlateItem& item : items) include(item.settings.planning);
  return common;
}

/// Of the bed, without room for skirt and tower.
Box2 roomFor(const std::vector<PlateItem>& items, const Box3& space, const JobSettings& settings) {
  const SkirtSettings& skirt = settings.planning.skirt;
  const double skirt_mm =
      skirt.count > 0 ? skirt.distance_mm + skirt.count * settings.planning.bead.width_mm : 0.0;
  const Point2 margin = Point2::Constant(skirt_mm);
  const Point2 tower(roomForTower(settings, towerNeighbours(items)), 0.0);
  const Box2 bed = commonReach(items, space, settings);
  return {bed.low + margin, bed.high - margin - tower};
}

void arrange(std::vector<PlateItem>& items, const Box3& space, const JobSettings& settings) {
  std::vector<Footprint> footprints;
  for (PlateItem& item : items) {
    item.turn = rotationOfDegrees(item.part.turn_deg);
    stand(item);
    std::optional<Point2> at = item.part.at_mm;
    if (!at && settings.plate.arrangement == PlateArrangement::None) at = placeInFile(item);
    const double cut_mm = settings.planning.skirt.count > 0 ? 0.0 : cutAtEdge(item.settings);
    footprints.push_back({item.name, footprintOf(item), at, reachBeside(item.settings), cut_mm});
  }
  const std::vector<PlatePlace> places =
      arranged(footprints, roomFor(items, space, settings), settings.plate);
  for (std::size_t i = 0; i < items.size(); ++i) {
    PlateItem& item = items[i];
    item.place = places[i];
    if (item.place.eighths == 0) continue;
    item.turn = rotationOfDegrees({0.0, 0.0, 45.0 * item.place.eighths}) * item.turn;
    stand(item);
  }
}

/// @param bed  where the nozzle may be: brims end there
std::vector<StandingPart> standingParts(const std::vector<PlateItem>& items, const Box2& bed,
                                        Progress& progress) {
  std::vector<StandingPart> parts;
  parts.reserve(items.size());
  for (const PlateItem& item : items) {
    const Point2& at = item.place.at_mm;
    parts.push_back({item.name, &item.mesh, boundingBox(item.mesh), at, nozzlesFor(item.settings.planning)});
    if (isUsed(item.settings.planning.adhesion))
      parts.back().beside =
          laidBeside(depositedMesh(item), item.settings, {bed.low - at, bed.high - at}, progress);
  }
  return parts;
}

/// Whether the bed ends a brim where the part stands.
bool isCutAtEdge(const PlateItem& item, const Box2& bed) {
  if (item.settings.planning.adhesion.brim.width_mm == 0.0) return false;
  const Box3 box = boundingBox(item.mesh);
  const Point2 reach = Point2::Constant(reachBeside(item.settings) + item.settings.planning.bead.width_mm);
  const Point2 low = item.place.at_mm + box.low.head<2>() - reach;
  const Point2 high = item.place.at_mm + box.high.head<2>() + reach;
  return (low.array() < bed.low.array()).any() || (high.array() > bed.high.array()).any();
}

/// What is the same for parts that are planned once.
std::string planKey(const PlateItem& item) {
  char numbers[192];
  std::snprintf(numbers, sizeof numbers, "%p|%a|%a|%a|%a|%a", static_cast<const void*>(item.source),
                item.part.scale, item.turn.x(), item.turn.y(), item.turn.z(), item.turn.w());
  std::string key = numbers;
  for (const SettingText& setting : item.part.settings) key += "|" + setting.key + "=" + setting.text;
  if (item.bed_around) {
    std::snprintf(numbers, sizeof numbers, "|%a|%a", item.place.at_mm.x(), item.place.at_mm.y());
    key += numbers;
  }
  return key;
}

SlicedPart planned(const PlateItem& item, const SliceJob& of_plate, const BuildSpace& space,
                   Progress& progress) {
  const SliceJob job{item.part.file, of_plate.output, item.settings};
  SourcePart source = *item.source;
  source.mesh = item.mesh;
  source.part_from_file = item.part_from_file;
  source.bed_around = item.bed_around;
  try {
    return sliceSource(std::move(source), job, space, progress);
  } catch (...) {
    rethrowAt("part '" + item.name + "'");
  }
}

void addSummary(SliceSummary& sum, const PlatedPart& part) {
  const SliceSummary& of_part = part.summary;
  for (const std::string& note : of_part.notes) sum.notes.push_back("part '" + part.name + "': " + note);
  for (const std::string& repair : of_part.repairs)
    sum.repairs.push_back("part '" + part.name + "': " + repair);
  if (of_part.lean.greatest_rad > sum.lean.greatest_rad) sum.lean = of_part.lean;
  sum.triangles += of_part.triangles;
  sum.contours += of_part.contours;
  sum.open_contours += of_part.open_contours;
  sum.mesh_volume_mm3 += of_part.mesh_volume_mm3;
  sum.sliced_volume_mm3 += of_part.sliced_volume_mm3;
  sum.unprinted_mm3 += of_part.unprinted_mm3;
  sum.starts += of_part.starts;
  sum.anchored.moved += of_part.anchored.moved;
  sum.anchored.in_air += of_part.anchored.in_air;
  sum.refilling.runs += of_part.refilling.runs;
  sum.bridging += of_part.bridging;
  const double area_mm2 = sum.supports.area_mm2 + of_part.supports.area_mm2;
  sum.supports = sumOf(sum.supports, of_part.supports);
  sum.supports.area_mm2 = area_mm2;  // parts stand beside each other
  sum.raft_mm = std::max(sum.raft_mm, of_part.raft_mm);
  sum.refilling.deposited_mm3 += of_part.refilling.deposited_mm3;
}

Polygon moved(Polygon polygon, const Point2& by) {
  for (Point2& point : polygon) point += by;
  return polygon;
}

/// Refuses what the head could touch, part by part.
std::vector<std::size_t> clearOrder(const std::vector<StandingPart>& parts, const JobSettings& settings) {
  std::vector<std::size_t> order = partOrder(parts);
  const CartesianMachine machine = machineOf(settings.machine);
  const MovingHead head{axesFromBed(machine), movingBodies(machine)};
  if (head.bodies.empty())
    throw InvalidConfig(
        "plate.order is 'by_part', and no body of the machine " + machine.name +
        "'s head is described; expected by_layer, or a description with <collision> elements");
  requireHeadClear(parts, order, head, settings.planning.bead.width_mm);
  return order;
}

std::string namesOf(const std::vector<PlateItem>& items) {
  std::string names;
  for (const PlateItem& item : items) names += (names.empty() ? "" : ", ") + item.name;
  return names;
}

/// Everything between meshes and the plate's toolpath.
class PlateSlicer {
 public:
  PlateSlicer(const PlateJob& job, const BuildSpace& space) : job_(job), space_(space) {}

  SlicedPart slice(const SliceJob& of_plate, Progress& progress, std::vector<PlatedPart>& reports) {
    requirePlateSettings(job_.settings);
    const bool is_along_belt = isInclined(job_.settings) && hasBelt(space_);
    if (is_along_belt)
      requireBeltSettings(job_.settings, job_.plate);
    else
      requireInclinable(job_.settings);
    Laps laps;
    Sources sources(job_.settings.input, progress);
    items_ = itemsOf(job_.plate, sources, job_.settings);
    if (is_along_belt) return sliceAlongBelt(of_plate, laps.lap(), progress, reports);
    requireNoFootBrims(items_);
    requireMergeable(items_, job_.settings.plate.order);
    const double read_s = laps.lap();
    arrange(items_, boundingBox(space_), job_.settings);
    const Box2 bed = commonReach(items_, boundingBox(space_), job_.settings);
    for (PlateItem& item : items_)
      if (isCutAtEdge(item, bed))
        item.bed_around = Box2{bed.low - item.place.at_mm, bed.high - item.place.at_mm};
    const std::vector<StandingPart> standing = standingParts(items_, bed, progress);
    requireOnBed(standing, boundingBox(space_), space_.name);
    requireNoOverlap(standing, job_.settings.slicing.layer_height_mm, progress);
    requireNoneBesideOverlaps(standing, job_.settings.slicing.first_layer_height_mm, progress);
    std::vector<std::size_t> order;
    if (job_.settings.plate.order == PlateOrder::ByPart) order = clearOrder(standing, job_.settings);
    planAll(of_plate, progress);
    SlicedPart plate;
    plate.toolpath = joined(order);
    summarise(plate, reports);
    plate.summary.read_s = read_s;
    requireWithin(space_, of_plate, plate);
    return plate;
  }

 private:
  SlicedPart sliceAlongBelt(const SliceJob& of_plate, double read_s, Progress& progress,
                            std::vector<PlatedPart>& reports) {
    for (PlateItem& item : items_) {
      item.turn = rotationOfDegrees(item.part.turn_deg);
      stand(item);
    }
    planAll(of_plate, progress);
    std::vector<BeltPart> parts;
    for (const PlateItem& item : items_) {
      const SlicedPart& plan = plans_.at(planKey(item));
      parts.push_back({item.name, &plan.toolpath, plan.bed_from_part});
    }
    const std::vector<Point3> places = placesAlongBelt(parts, job_.settings.copies.spacing_mm, space_);
    std::vector<LabelledPart> labelled;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      items_[i].place.at_mm = (parts[i].bed_from_part.translation() + places[i]).head<2>();
      labelled.push_back({parts[i].name, moved(hullOf(items_[i].mesh), items_[i].place.at_mm)});
    }
    SlicedPart plate;
    plate.bed_from_part = parts.front().bed_from_part;
    plate.toolpath = oneAfterAnother(parts, places, space_, job_.settings.planning.travel.feed_mm_s);
    addLabels(plate.toolpath, labelled, job_.settings.plate.labels);
    plate.toolpath.part_name = namesOf(items_);
    summarise(plate, reports);
    plate.summary.read_s = read_s;
    requireWithin(space_, of_plate, plate);
    return plate;
  }

  void planAll(const SliceJob& of_plate, Progress& progress) {
    for (const PlateItem& item : items_) {
      const std::string key = planKey(item);
      if (plans_.count(key) == 0) plans_.emplace(key, planned(item, of_plate, space_, progress));
    }
  }

  /// In the frame of the layers, in which those of inclined ones are level too.
  Toolpath joined(const std::vector<std::size_t>& order) {
    std::vector<PlateToolpath> parts;
    std::vector<LabelledPart> labelled;
    const PlaneSettings& plane = job_.settings.slicing.plane;
    const Eigen::Quaterniond layers_from_part = partFromLayers(plane).conjugate();
    if (isInclined(job_.settings))
      for (auto& [key, plan] : plans_) plan.toolpath = inLayerFrame(std::move(plan.toolpath));
    for (const PlateItem& item : items_) {
      const SlicedPart& plan = plans_.at(planKey(item));
      const Point2& at = item.place.at_mm;
      const Point3 on_bed(at.x(), at.y(), plan.bed_from_part.translation().z());
      parts.push_back(
          {item.name, &plan.toolpath, isInclined(job_.settings) ? layers_from_part * on_bed : on_bed});
      labelled.push_back({item.name, moved(hullOf(item.mesh), item.place.at_mm)});
    }
    requireAidsApart(parts);
    const PlanSettings& settings = job_.settings.planning;
    Toolpath plate =
        order.empty() ? mergedByLayer(parts, settings.travel) : partAfterPart(parts, order, settings.travel);
    if (!isInclined(job_.settings))
      addRoundParts(plate, parts, settings, commonReach(items_, boundingBox(space_), job_.settings));
    if (!settings.tools.purge_mm3.empty()) plate = withTower(std::move(plate), settings);
    plate = inPartFrame(std::move(plate), plane);
    addLabels(plate, labelled, job_.settings.plate.labels);
    plate.part_name = namesOf(items_);
    return plate;
  }

  void summarise(SlicedPart& plate, std::vector<PlatedPart>& reports) const {
    plate.summary.mode = job_.settings.slicing.mode;
    for (const PlateItem& item : items_) {
      PlatedPart report;
      report.name = item.name;
      report.file = item.part.file;
      report.at_mm = item.place.at_mm;
      report.arranged_turn_deg = 45.0 * item.place.eighths;
      report.size_mm = boundingBox(item.mesh).size();
      report.summary = plans_.at(planKey(item)).summary;
      addSummary(plate.summary, report);
      reports.push_back(std::move(report));
    }
    for (const auto& [key, plan] : plans_) plate.summary.slice_s += plan.summary.slice_s;
    plate.summary.layers = plate.toolpath.layers.size();
    addToolpath(plate.summary, plate.toolpath);
  }

  const PlateJob& job_;
  const BuildSpace& space_;
  std::vector<PlateItem> items_;
  std::map<std::string, SlicedPart> plans_;
};

}  // namespace

SlicedPlate runPlateJob(const PlateJob& job, Progress& progress) {
  if (job.plate.parts.empty()) throw InvalidInput("the plate has no part; expected one at least");
  validate(job.settings);
  std::vector<std::string> files;
  for (const PlatePart& part : job.plate.parts) files.push_back(part.file);
  requireApart({job.output}, files);
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  SlicedPlate result;
  const auto slice = [&](const SliceJob& of_plate, const BuildSpace&, Progress& reported) {
    return PlateSlicer(job, space).slice(of_plate, reported, result.parts);
  };
  result.sliced = runIn(space, {job.plate.parts.front().file, job.output, job.settings}, slice, progress);
  return result;
}

}  // namespace lamina
