// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/machine_defaults.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/number_text.hpp"
#include "lamina/job/modes/slicing_mode.hpp"

namespace lamina {
namespace {

constexpr const char* kNozzle = "machine.nozzle_mm";
// Of the nozzle's diameter; the ratios of the built-in values, which are those of a nozzle of 0.4 mm.
constexpr double kBeadWidth = 1.0;
constexpr double kLayerHeight = 0.5;
constexpr double kLeastAdaptive = 0.25;
constexpr double kGreatestAdaptive = 0.75;

/// Level layers come first in `auto`, unless other settings choose a mode that may lay all layers alike.
bool hasOwnFirstLayer(const JobSettings& settings) {
  const std::string& mode = settings.slicing.mode;
  if (mode == kAutoMode) return settings.conformal.base.empty() && !settings.automatic.follows_skins;
  return slicingModes().find(mode).first_layer == FirstLayer::OwnHeight;
}

/// A height of layers, and the setting of the machine that it follows from; none for the built-in one.
struct FollowedHeight {
  double height_mm;
  const char* follows;
};

class DefaultsOfMachine {
 public:
  DefaultsOfMachine(const JobSettings& settings, const StatedKeys& stated)
      : settings_(settings), stated_(stated) {
    describe(schema_, settings_);
  }

  std::vector<MachineDefault> find() && {
    leaveOutWhatIsMissing();
    followNozzle();
    return std::move(defaults_);
  }

 private:
  bool isStated(const char* key) const { return stated_.anywhere.count(key) != 0; }

  void add(const char* key, const std::string& text, const char* follows) {
    if (schema_.find(key)->get() == text) return;
    schema_.set(key, text);
    defaults_.push_back({{key, text}, follows});
  }

  void leaveOutWhatIsMissing() {
    const MachineCapabilities& machine = settings_.capabilities;
    if (!machine.has_fan && stated_.typed.count("fan.use") == 0) add("fan.use", "false", "machine.has_fan");
    if (!machine.has_bed_heater && stated_.typed.count("program.bed_temperature_c") == 0)
      add("program.bed_temperature_c", "0", "machine.has_bed_heater");
  }

  void followNozzle() {
    const double nozzle_mm = settings_.capabilities.nozzle_mm;
    SlicingSettings& slicing = settings_.slicing;
    if (nozzle_mm > 0.0 && !isStated("bead.width_mm"))
      add("bead.width_mm", numberText(kBeadWidth * nozzle_mm), kNozzle);
    addHeight("slicing.layer_height_mm", followed(kLayerHeight, slicing.layer_height_mm));
    followFirstLayer(followed(kLayerHeight, slicing.first_layer_height_mm));
    const bool has_greatest = isStated("adaptive.greatest_mm");
    FollowedHeight least = followed(kLeastAdaptive, slicing.adaptive.least_mm);
    if (has_greatest) least.height_mm = std::min(least.height_mm, slicing.adaptive.greatest_mm);
    addHeight("adaptive.least_mm", least);
    FollowedHeight greatest = followed(kGreatestAdaptive, slicing.adaptive.greatest_mm);
    greatest.height_mm = std::max(greatest.height_mm, slicing.adaptive.least_mm);
    addHeight("adaptive.greatest_mm", greatest);
  }

  /// Modes that may lay all layers alike refuse a first one of another height, but for the built-in one.
  void followFirstLayer(FollowedHeight first) {
    const SlicingSettings& slicing = settings_.slicing;
    const bool is_built_in = numberText(first.height_mm) == numberText(slicing.first_layer_height_mm);
    if (!hasOwnFirstLayer(settings_) && !is_built_in) first.height_mm = slicing.layer_height_mm;
    addHeight("slicing.first_layer_height_mm", first);
  }

  /// A share of the nozzle, the built-in height where no nozzle is known, within what the machine can lay.
  FollowedHeight followed(double share, double built_in_mm) const {
    const MachineCapabilities& machine = settings_.capabilities;
    FollowedHeight height = machine.nozzle_mm > 0.0 ? FollowedHeight{share * machine.nozzle_mm, kNozzle}
                                                    : FollowedHeight{built_in_mm, nullptr};
    if (machine.greatest_layer_mm > 0.0 && height.height_mm > machine.greatest_layer_mm)
      height = {machine.greatest_layer_mm, "machine.greatest_layer_mm"};
    if (height.height_mm < machine.least_layer_mm)
      height = {machine.least_layer_mm, "machine.least_layer_mm"};
    return height;
  }

  void addHeight(const char* key, const FollowedHeight& height) {
    if (height.follows != nullptr && !isStated(key)) add(key, numberText(height.height_mm), height.follows);
  }

  JobSettings settings_;
  const StatedKeys& stated_;
  SettingsSchema schema_;
  std::vector<MachineDefault> defaults_;
};

}  // namespace

std::vector<MachineDefault> machineDefaults(const JobSettings& settings, const StatedKeys& stated) {
  return DefaultsOfMachine(settings, stated).find();
}

std::set<std::string> changedKeys(const JobSettings& settings) {
  JobSettings changed = settings;
  JobSettings built_in;
  SettingsSchema changed_schema;
  SettingsSchema built_in_schema;
  describe(changed_schema, changed);
  describe(built_in_schema, built_in);
  std::set<std::string> keys;
  for (std::size_t i = 0; i < changed_schema.settings().size(); ++i)
    if (changed_schema.settings()[i].get() != built_in_schema.settings()[i].get())
      keys.insert(changed_schema.settings()[i].key);
  return keys;
}

JobSettings withMachineDefaults(JobSettings settings, const std::set<std::string>& typed) {
  SettingsSchema schema;
  describe(schema, settings);
  StatedKeys stated;
  for (const std::string& key : typed) {
    const Setting* const setting = schema.find(key);
    stated.typed.insert(setting == nullptr ? key : setting->key);
  }
  stated.anywhere = stated.typed;
  for (const MachineDefault& each : machineDefaults(settings, stated))
    schema.set(each.setting.key, each.setting.text);
  settings.giving_way.keys = keysGivingWay(stated.typed);
  return withoutLeftOut(std::move(settings));
}

}  // namespace lamina
