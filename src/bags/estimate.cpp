// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "arguments/setting_options.hpp"
#include "correction_messages.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/control/program/correction_files.hpp"
#include "lamina/control/report/loop_report.hpp"
#include "lamina/control/run/run_calibration.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "recorded_print.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina estimate` as it was typed.
struct EstimateArguments {
  std::string bag;
  std::string output;
  std::string space;
  SettingOptions settings;
  bool prints_config = false;
};

/// A print of the bag, as it went on.
struct EstimatedPrint {
  LoopRecord record;
  std::map<std::size_t, std::string> digests;  ///< of the latest map of each layer
  std::vector<std::string> map_digests;        ///< of all maps, in the order in which they were made
  std::vector<std::string> coasting_digests;   ///< the same of coasting maps
  std::vector<RaisedAlarm> alarms;
  std::vector<PrintPlan> plans;  ///< that were offered
  LoopStatus status;
  LoopCounts counts;
  FeedCounts feed;
};

/// Makes the folder of a print: the first is the one asked for, others are beside it.
std::string folderOf(const std::string& output, std::size_t print) {
  std::string folder = print == 0 ? output : output + "_" + std::to_string(print + 1);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError("cannot make the folder " + folder + ": " + failure.message());
  return folder;
}

void writeMap(const std::string& folder, const CorrectionMap& map) {
  writeFile(folder + "/correction_" + std::to_string(map.layer) + ".csv", correctionMapCsv(map));
}

/// The toolpath as programs for a machine of linear axes have it, so that these can be corrected by the maps.
void writeToolpath(const std::string& folder, const PlacedPart& part) {
  writeFile(folder + "/" + kProgrammedToolpathFile,
            programmedToolpathCsv({part.toolpath_id, placed(part.toolpath, part.bed_from_part)}));
}

class Estimation {
 public:
  explicit Estimation(std::string output) : output_(std::move(output)) {}

  PrintReceivers receivers() {
    return {[this](const LoopRun& run) { begin(run); },
            [this](const LoopRun&, const LoopNews& news) { take(news); },
            [this](const LoopRun& run, const FeedCounts& counts) { end(run, counts); }};
  }
  const std::vector<EstimatedPrint>& prints() const { return prints_; }

 private:
  void begin(const LoopRun& run) {
    prints_.emplace_back();
    prints_.back().record = LoopRecord(run.part().toolpath.part_name, run.part().toolpath_id);
    if (output_.empty()) return;
    folder_ = folderOf(output_, prints_.size() - 1);
    writeToolpath(folder_, run.part());
  }

  void take(const LoopNews& news) {
    EstimatedPrint& print = prints_.back();
    print.alarms.insert(print.alarms.end(), news.alarms.begin(), news.alarms.end());
    print.plans.insert(print.plans.end(), news.plans.begin(), news.plans.end());
    for (const CorrectionMap& map : news.coasting_maps)
      print.coasting_digests.push_back(toMessage(map).digest);
    takeMaps(news.maps);
    for (const LayerOutcome& layer : news.layers) print.record.add(layer, print.digests[layer.figures.layer]);
  }

  void takeMaps(const std::vector<CorrectionMap>& maps) {
    EstimatedPrint& print = prints_.back();
    for (const CorrectionMap& map : maps) {
      const lamina_msgs::CorrectionMap message = toMessage(map);
      print.digests[map.layer] = message.digest;
      print.map_digests.push_back(message.digest);
      if (!folder_.empty()) writeMap(folder_, toCore(message));
    }
  }

  void end(const LoopRun& run, const FeedCounts& counts) {
    prints_.back().status = run.status();
    prints_.back().counts = run.counts();
    prints_.back().feed = counts;
    if (folder_.empty()) return;
    saveLoopReport(folder_, prints_.back().record);
    if (const auto map = run.learnt(PartEnd::Complete))
      writeFile(folder_ + "/learnt_part.csv", partMapCsv(*map));
  }

  std::string output_;
  std::string folder_;
  std::vector<EstimatedPrint> prints_;
};

nlohmann::ordered_json jsonOf(const LayerRecord& layer) {
  const LayerFigures& figures = layer.figures;
  nlohmann::ordered_json alarms = nlohmann::ordered_json::array();
  for (const RaisedAlarm& alarm : layer.alarms) alarms.push_back(static_cast<int>(alarm.alarm));
  return {{"layer", figures.layer},
          {"state", toString(layer.state)},
          {"rmse_mm", figures.rmse_mm},
          {"flatness_mm", figures.flatness_mm},
          {"mean_error_mm", figures.mean_error_mm},
          {"coverage", figures.coverage},
          {"limited_share", figures.limited_share},
          {"gain_mean", figures.gain_mean},
          {"gain_least", figures.gain_least},
          {"gain_greatest", figures.gain_greatest},
          {"alarms", alarms},
          {"map_digest", layer.map_digest}};
}

nlohmann::ordered_json jsonOf(const PrintPlan& plan) {
  return {{"toolpath_id", plan.part.toolpath_id}, {"layer", plan.layer}, {"reason", plan.reason}};
}

nlohmann::ordered_json jsonOf(const PointCounts& points) {
  return {{"received", points.received},
          {"used", points.used},
          {"trimmed", points.trimmed},
          {"not_finite", points.not_finite},
          {"outside_window", points.outside_window},
          {"spray", points.spray},
          {"off_path", points.off_path},
          {"grazing", points.grazing},
          {"beside_crown", points.beside_crown},
          {"mirrored", points.mirrored}};
}

nlohmann::ordered_json jsonOf(const EstimatedPrint& print) {
  nlohmann::ordered_json plans = nlohmann::ordered_json::array();
  for (const PrintPlan& plan : print.plans) plans.push_back(jsonOf(plan));
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (const LayerRecord& layer : print.record.layers()) layers.push_back(jsonOf(layer));
  return {{"part", print.record.partName()},
          {"toolpath_id", print.record.toolpathId()},
          {"state", toString(print.status.state)},
          {"reason", print.status.reason},
          {"layers", layers},
          {"map_digests", print.map_digests},
          {"coasting_digests", print.coasting_digests},
          {"plans", plans},
          {"clouds", print.feed.received},
          {"clouds_read", print.counts.clouds_read},
          {"clouds_late", print.counts.clouds_late},
          {"clouds_stuck", print.counts.clouds_stuck},
          {"clouds_without_frame", print.feed.without_frame},
          {"clouds_without_offset", print.feed.without_offset},
          {"clouds_malformed", print.feed.malformed},
          {"clouds_without_transform", print.feed.without_transform},
          {"clouds_waiting", print.feed.waiting + print.counts.clouds_waiting},
          {"clouds_pushed_out", print.feed.pushed_out},
          {"clouds_of_former_print", print.feed.of_former_print},
          {"readings_used", print.counts.readings_used},
          {"readings_contested", print.counts.readings_contested},
          {"readings_believed", print.counts.readings_believed},
          {"readings_below", print.counts.readings_below},
          {"points", jsonOf(print.counts.points)},
          {"trims_refused", print.counts.trims_refused}};
}

/// Those received, and by what became of them the numbers of which they are the sum.
std::string cloudsText(const EstimatedPrint& print) {
  const FeedCounts& feed = print.feed;
  std::string text =
      std::to_string(feed.received) + " received, " + std::to_string(print.counts.clouds_read) + " read, " +
      std::to_string(print.counts.clouds_late) + " late, " + std::to_string(feed.without_transform) +
      " without transform, " + std::to_string(feed.malformed) + " malformed";
  const auto addIfAny = [&text](std::uint64_t clouds, const std::string& what) {
    if (clouds > 0) text += ", " + std::to_string(clouds) + " " + what;
  };
  addIfAny(print.counts.clouds_stuck, "of a stuck sensor");
  addIfAny(feed.without_offset,
           "of frame '" + feed.last_without_offset + "', which sensor.other_time_offsets_s does not name");
  addIfAny(feed.without_frame, "without frame or stamp");
  addIfAny(feed.waiting + print.counts.clouds_waiting, "waiting for tf");
  addIfAny(feed.pushed_out, "pushed out");
  addIfAny(feed.of_former_print, "of the print before");
  return text;
}

void printText(const EstimatedPrint& print) {
  std::printf("%s, toolpath %s: loop %s%s%s\n", print.record.partName().c_str(),
              print.record.toolpathId().c_str(), toString(print.status.state),
              print.status.reason.empty() ? "" : ": ", print.status.reason.c_str());
  std::printf("layer  rmse mm  mean mm  flat mm  seen %%   gain  map\n");
  for (const LayerRecord& layer : print.record.layers()) {
    const LayerFigures& figures = layer.figures;
    std::printf("%5zu  %7.3f  %7.3f  %7.3f  %6.1f  %5.3f  %s\n", figures.layer, figures.rmse_mm,
                figures.mean_error_mm, figures.flatness_mm, 100.0 * figures.coverage, figures.gain_mean,
                layer.map_digest.c_str());
  }
  for (const RaisedAlarm& alarm : print.alarms)
    std::printf("alarm %d: %s\n", static_cast<int>(alarm.alarm), alarm.reason.c_str());
  std::printf("clouds: %s\n", cloudsText(print).c_str());
}

void estimate(const EstimateArguments& arguments, OutputFormat format) {
  LoopRunSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applySettings(schema, arguments.settings.config, overridesFrom(arguments.settings.assignments));
  if (arguments.prints_config) return printConfig(schema, format);
  if (arguments.bag.empty()) throw InvalidInput("no bag is given; expected a file that rosbag recorded");
  settings = withCalibrationFile(settings);
  Estimation estimation(arguments.output);
  const SteadyClock clock;
  const double begin = clock.now();
  const BagFigures bag = runRecordedPrints(arguments.bag, arguments.space, settings, estimation.receivers());
  const double elapsed_s = clock.now() - begin;
  if (estimation.prints().empty())
    throw InvalidInput("'" + arguments.bag + "' has no toolpath among its " + std::to_string(bag.messages) +
                       " messages; expected the topics toolpath, profile, /tf and /tf_static");
  if (format == OutputFormat::Json) {
    nlohmann::ordered_json prints = nlohmann::ordered_json::array();
    for (const EstimatedPrint& print : estimation.prints()) prints.push_back(jsonOf(print));
    const nlohmann::ordered_json json = {{"calibration", settings.calibration.sources},
                                         {"prints", prints},
                                         {"recorded_s", bag.recorded_s},
                                         {"elapsed_s", elapsed_s}};
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  for (const std::string& source : settings.calibration.sources) std::printf("%s\n", source.c_str());
  for (const EstimatedPrint& print : estimation.prints()) printText(print);
  std::printf("%.1f s recorded, read in %.2f s\n", bag.recorded_s, elapsed_s);
}

}  // namespace

void addEstimate(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("estimate", kEstimateDescription);
  const auto arguments = std::make_shared<EstimateArguments>();
  subcommand->add_option(
      "bag", arguments->bag,
      "Bag with toolpath, profile, /tf and /tf_static, and applied_correction where a machine reported it");
  subcommand->add_option("-o,--output", arguments->output,
                         "Folder for the report, the figures and the map of each layer");
  subcommand->add_option("--namespace", arguments->space, "Namespace in which the topics were recorded");
  subcommand->add_flag("--print-config", arguments->prints_config, "Print all settings and end");
  addSettingOptions(*subcommand, arguments->settings,
                    "Settings (YAML), as the node height_controller has them");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { estimate(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
