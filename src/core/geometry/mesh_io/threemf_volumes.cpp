// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "threemf_volumes.hpp"

#include <zip.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/mesh_io/volume_origin.hpp"
#include "geometry/svg/xml_scanner.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostBytes = 64U << 20U;     // of a list of volumes
constexpr std::size_t kMostOfModel = 4ULL << 30U;  // bytes
constexpr const char* kModelRelation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// By the numbers that the model gives its objects.
using NumberedObjects = std::map<std::uint32_t, ObjectWords>;

struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

Archive opened(std::string_view bytes, const std::string& name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  Archive archive(source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  const std::string reason = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive) return archive;
  if (source != nullptr) zip_source_free(source);
  throw InvalidMesh(name + ": no readable archive: " + reason);
}

/// The text of an entry; none if there is none of that name. Headers may state any size: only what is there
/// takes room.
std::optional<std::string> entryOf(const Archive& archive, const std::string& entry, std::size_t most_bytes,
                                   const std::string& name) {
  constexpr std::size_t kBlock = 1U << 20U;  // bytes
  if (zip_name_locate(archive.get(), entry.c_str(), 0) < 0) return std::nullopt;
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen(archive.get(), entry.c_str(), 0));
  std::string text;
  std::vector<char> block(kBlock);
  zip_int64_t count = file ? 0 : -1;
  while (file && (count = zip_fread(file.get(), block.data(), block.size())) > 0) {
    text.append(block.data(), static_cast<std::size_t>(count));
    if (text.size() > most_bytes)
      throw InvalidMesh(name + ": " + entry + " has more than " + std::to_string(most_bytes) +
                        " bytes; no more are read");
  }
  if (count < 0) throw InvalidMesh(name + ": " + entry + " cannot be read");
  return text;
}

/// The first bytes of an entry; fewer if it is shorter, none if it is not there.
std::string startOf(const Archive& archive, const std::string& entry, std::size_t count) {
  const std::unique_ptr<zip_file_t, CloseEntry> file(zip_fopen(archive.get(), entry.c_str(), 0));
  std::string start(count, '\0');
  const zip_int64_t got = file ? zip_fread(file.get(), start.data(), count) : 0;
  start.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return start;
}

/// Of any slicer's words; none for a volume of the part.
std::optional<VolumeKind> kindOfVolume(const std::string& word) {
  if (word == "ParameterModifier" || word == "modifier_part") return VolumeKind::Modifier;
  if (word == "NegativeVolume" || word == "negative_part") return VolumeKind::Negative;
  if (word == "SupportBlocker" || word == "support_blocker") return VolumeKind::SupportBlocker;
  if (word == "SupportEnforcer" || word == "support_enforcer") return VolumeKind::SupportEnforcer;
  return std::nullopt;
}

std::uint32_t numberOf(const XmlScanner& scanner, const XmlTag& tag, const std::string& key) {
  const std::string text = tag.attribute(key);
  std::uint32_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
    scanner.refuse(tag.line, key + " of " + tag.name + " is '" + text + "'; expected a number");
  return value;
}

/// Of a slicer's list of objects.
class ListScanner {
 public:
  ListScanner(const std::string& text, const std::string& name) : scanner_(text, name) {}

  NumberedObjects scan() {
    XmlTag tag;
    while (scanner_.next(tag)) {
      if (tag.is_end)
        end(tag);
      else
        begin(tag);
    }
    return std::move(found_);
  }

 private:
  void begin(const XmlTag& tag) {
    if (tag.name == "object") {
      object_ = numberOf(scanner_, tag, "id");
      within_ = Within::Object;
    }
    if (tag.name == "volume") {
      within_ = Within::Volume;
      range_ = {VolumeKind::Material, numberOf(scanner_, tag, "firstid"), numberOf(scanner_, tag, "lastid")};
    }
    if (tag.name == "part") beginPart(tag);
    if (tag.name == "metadata") addWord(tag);
    if (tag.is_empty) end(tag);
  }

  void beginPart(const XmlTag& tag) {
    within_ = Within::Part;
    const auto kind = kindOfVolume(tag.attribute("subtype"));
    range_ = {kind.value_or(VolumeKind::Material), 0, std::numeric_limits<std::size_t>::max()};
    part_ = numberOf(scanner_, tag, "id");
    // Each is all triangles of an object.
    if (!parts_.insert(part_).second)
      scanner_.refuse(tag.line, "part " + std::to_string(part_) + " is listed twice; expected each once");
  }

  void addWord(const XmlTag& tag) {
    const std::string key = tag.attribute("key");
    // Of plates, and of where objects stand on them; counts of faces have no key.
    if (within_ == Within::Outside || key.empty()) return;
    const std::string value = tag.attribute("value");
    if (key == "volume_type") range_.kind = kindOfVolume(value).value_or(VolumeKind::Material);
    if (saysOrigin(key)) return;
    (within_ == Within::Object ? found_[object_].settings : range_.settings).push_back({key, value});
  }

  void end(const XmlTag& tag) {
    if (tag.name == "object") within_ = Within::Outside;
    if (tag.name != "volume" && tag.name != "part") return;
    // Of material there is nothing to say but settings.
    const std::uint32_t number = within_ == Within::Volume ? object_ : part_;
    if (range_.kind != VolumeKind::Material || !range_.settings.empty())
      found_[number].volumes.push_back(range_);
    within_ = Within::Object;
  }

  enum class Within : std::uint8_t { Outside, Object, Volume, Part };

  XmlScanner scanner_;
  Within within_ = Within::Outside;
  std::uint32_t object_ = 0;
  std::uint32_t part_ = 0;
  std::set<std::uint32_t> parts_;  ///< so far
  VolumeRange range_;
  NumberedObjects found_;
};

double heightOf(const XmlScanner& scanner, const XmlTag& tag, const std::string& key) {
  const std::string text = tag.attribute(key);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || !std::isfinite(value))
    scanner.refuse(tag.line, key + " of " + tag.name + " is '" + text + "'; expected a height in mm");
  return value;
}

/// Of a slicer's list of ranges of heights, which counts objects from 1.
std::map<std::size_t, std::vector<RangeOfHeights>> heightRanges(const std::string& text,
                                                                const std::string& name) {
  std::map<std::size_t, std::vector<RangeOfHeights>> found;
  XmlScanner scanner(text, name);
  std::uint32_t object = 0;
  XmlTag tag;
  while (scanner.next(tag)) {
    if (tag.is_end) continue;
    if (tag.name == "object") {
      object = numberOf(scanner, tag, "id");
      if (object == 0) scanner.refuse(tag.line, "id of object is 0; expected at least 1");
    }
    if (tag.name == "range") {
      const RangeOfHeights range = {heightOf(scanner, tag, "min_z"), heightOf(scanner, tag, "max_z"), {}};
      if (object == 0) scanner.refuse(tag.line, "range outside of any object");
      if (!(range.from_mm < range.to_mm))
        scanner.refuse(tag.line, "min_z is " + tag.attribute("min_z") + " and max_z " +
                                     tag.attribute("max_z") + "; expected the former below the latter");
      found[object - 1].push_back(range);
    }
    if (tag.name == "option" && object > 0 && !found[object - 1].empty())
      found[object - 1].back().settings.push_back({tag.attribute("opt_key"), scanner.textBehind()});
  }
  return found;
}

/// What a word of Cura's makes of a whole object; none if it is a setting.
std::optional<VolumeKind> kindByCura(const SettingText& word) {
  const bool is_set = word.text == "True" || word.text == "true";
  if (!is_set) return std::nullopt;
  if (word.key == "cura:infill_mesh" || word.key == "cura:cutting_mesh") return VolumeKind::Modifier;
  if (word.key == "cura:anti_overhang_mesh") return VolumeKind::SupportBlocker;
  return std::nullopt;
}

/// Of the objects of a model that Cura wrote.
NumberedObjects objectsOfCura(const std::string& model, const std::string& name) {
  constexpr std::string_view kPrefix = "cura:";
  NumberedObjects found;
  XmlScanner scanner(model, name);
  std::optional<std::uint32_t> object;
  XmlTag tag;
  while (scanner.next(tag)) {
    if (tag.name == "object") {
      object.reset();
      if (!tag.is_end && !tag.is_empty) object = numberOf(scanner, tag, "id");
    }
    if (tag.is_end || !object) continue;
    SettingText word = {
        tag.name == "setting" ? std::string(kPrefix) + tag.attribute("key") : tag.attribute("name"),
        scanner.textBehind()};
    const bool is_word = tag.name == "setting" || tag.name == "metadata";
    if (!is_word || word.key.compare(0, kPrefix.size(), kPrefix) != 0 || saysOrigin(word.key)) continue;
    ObjectWords& words = found[*object];
    const auto kind = kindByCura(word);
    if (kind)
      words.volumes = {{*kind, 0, std::numeric_limits<std::size_t>::max()}};
    else
      words.settings.push_back(std::move(word));
  }
  for (auto& [number, words] : found)
    if (!words.volumes.empty()) words.volumes.front().settings = std::exchange(words.settings, {});
  return found;
}

/// Where the archive says that its model is.
std::string modelEntry(const Archive& archive, const std::string& name) {
  const std::string relations = entryOf(archive, "_rels/.rels", kMostBytes, name).value_or("");
  XmlScanner scanner(relations, name + ", _rels/.rels");
  XmlTag tag;
  while (scanner.next(tag)) {
    if (tag.is_end || tag.name != "Relationship" || tag.attribute("Type") != kModelRelation) continue;
    const std::string target = tag.attribute("Target");
    return target.substr(target.compare(0, 1, "/") == 0 ? 1 : 0);
  }
  throw InvalidMesh(name + ": _rels/.rels names no model; expected a relationship of type " +
                    std::string(kModelRelation));
}

/// The numbers of the objects of a model, in their order.
std::vector<std::uint32_t> objectNumbers(const std::string& model, const std::string& name) {
  std::vector<std::uint32_t> numbers;
  XmlScanner scanner(model, name);
  XmlTag tag;
  while (scanner.next(tag))
    if (!tag.is_end && tag.name == "object") numbers.push_back(numberOf(scanner, tag, "id"));
  return numbers;
}

bool isOfMaterial(const ObjectWords& words) {
  return std::all_of(words.volumes.begin(), words.volumes.end(),
                     [](const VolumeRange& volume) { return volume.kind == VolumeKind::Material; });
}

/// By the order in which a model has its objects.
std::map<std::size_t, ObjectWords> inOrder(NumberedObjects numbered, const std::string& model,
                                           const std::string& name) {
  std::map<std::size_t, ObjectWords> ordered;
  std::size_t order = 0;
  for (const std::uint32_t number : objectNumbers(model, name)) {
    if (auto found = numbered.extract(number)) ordered[order] = std::move(found.mapped());
    ++order;
  }
  for (const auto& [number, words] : numbered)
    if (!isOfMaterial(words))
      throw InvalidMesh(name + ": object " + std::to_string(number) +
                        " is listed with volumes that are no material, and is none of the " +
                        std::to_string(order) + " objects there; expected the number of one");
  return ordered;
}

std::map<std::size_t, ObjectWords> objectWords(const Archive& archive, const std::string& name) {
  constexpr std::size_t kStartOfModel = 4096;  // bytes, in which a model declares its name spaces
  const std::string entry = modelEntry(archive, name);
  NumberedObjects numbered;
  for (const char* const list : {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"}) {
    const auto text = entryOf(archive, list, kMostBytes, name);
    if (!text) continue;
    numbered = ListScanner(*text, name + ", " + list).scan();
    break;
  }
  const bool is_of_cura = startOf(archive, entry, kStartOfModel).find("xmlns:cura=") != std::string::npos;
  if (numbered.empty() && !is_of_cura) return {};
  const std::string model = entryOf(archive, entry, kMostOfModel, name).value_or("");
  if (is_of_cura) numbered.merge(objectsOfCura(model, name + ", " + entry));
  return inOrder(std::move(numbered), model, name + ", " + entry);
}

}  // namespace

SlicerWords slicerWords(std::string_view archive_bytes, const std::string& name) {
  const Archive archive = opened(archive_bytes, name);
  SlicerWords words;
  words.objects = objectWords(archive, name);
  for (const char* const list :
       {"Metadata/Prusa_Slicer_layer_config_ranges.xml", "Metadata/layer_config_ranges.xml"}) {
    const auto text = entryOf(archive, list, kMostBytes, name);
    if (!text) continue;
    words.heights = heightRanges(*text, name + ", " + list);
    break;
  }
  return words;
}

}  // namespace lamina
