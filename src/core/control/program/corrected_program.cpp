// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/corrected_program.hpp"

#include <algorithm>
#include <cmath>

#include "control/program/corrected_pieces.hpp"
#include "control/program/deposit_cursor.hpp"
#include "gcode_rewrite/decimal_number.hpp"
#include "gcode_rewrite/motion_text.hpp"
#include "gcode_rewrite/program_tracker.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

constexpr double kSameFeed = 5e-3;  // mm/min: the last decimal written
constexpr double kNoOffset = 1e-9;  // mm

/// A piece of a motion as it is written.
struct WrittenPiece {
  Point3 end = Point3::Zero();  ///< of the program
  double pushed = 0.0;          ///< filament, of the program
  PointCorrection correction;
  double end_dz_mm = 0.0;
};

RewriteSettings trackerSettings(const CorrectionWriting& writing) {
  RewriteSettings settings;
  settings.homing = Homing::Kept;
  settings.initial_extrusion = writing.initial_extrusion;
  return settings;
}

double roundedExtrusion(double value) {
  const double units = kPowersOfTen[kExtrusionDecimals];
  return std::round(value * units) / units;
}

void requireShiftsWithinLayer(const CorrectionMap& map, const Toolpath& toolpath) {
  if (map.layer >= toolpath.layers.size())
    throw InvalidInput("a correction map is of layer " + std::to_string(map.layer) + "; expected one of " +
                       std::to_string(toolpath.layers.size()));
  const double height = toolpath.layers[map.layer].height_mm;
  for (const PathCorrection& path : map.paths)
    for (const PointCorrection& place : path.stations)
      if (std::abs(place.dz_mm) > height)
        throw InvalidInput("the correction map of layer " + std::to_string(map.layer) +
                           " shifts the nozzle by " + numberText(place.dz_mm) +
                           " mm; expected no more than the layer's " + numberText(height) + " mm");
}

}  // namespace

class ProgramCorrector::Writer {
 public:
  Writer(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps, const CorrectionWriting& writing)
      : cursor_(toolpath, writing.place_tolerance_mm),
        tracker_(trackerSettings(writing)),
        writing_(writing),
        normal_(layerNormal(toolpath)),
        toolpath_(toolpath),
        toolpath_id_(toolpathId(toolpath)) {
    if (!(writing_.split_change > 0.0))
      throw InvalidInput("lines are split where the amount changes by " + numberText(writing_.split_change) +
                         "; expected a positive change");
    for (const CorrectionMap& map : maps) add(map);
  }

  void add(const CorrectionMap& map) {
    requireOfToolpath(map);
    if (cursor_.hasBegun(map.layer))
      throw InvalidInput("the correction map of layer " + std::to_string(map.layer) +
                         " comes while that layer is deposited; expected it before");
    corrections_.add(map);
  }

  void trim(const CorrectionMap& map) {
    requireOfToolpath(map);
    corrections_.replace(map);
  }

  void read(std::string_view line, std::size_t number, std::string& out) {
    line_ = line;
    const LineRole role = tracker_.read(line, number);
    if (tracker_.mark() == SectionMark::PartEnd) tracker_.leavePart();
    switch (role) {
      case LineRole::Motion:
        writeMotion(out);
        // What comes behind the last path is no longer of the part, whether a comment says so or not.
        if (cursor_.isAtEnd()) tracker_.leavePart();
        return;
      case LineRole::Filament:
        return writePlain(out, 0.0);
      default:
        return copy(out);
    }
  }
  const CorrectionReport& report() const { return report_; }

 private:
  void requireOfToolpath(const CorrectionMap& map) const {
    if (map.toolpath_id != toolpath_id_)
      throw InvalidInput("the correction map of layer " + std::to_string(map.layer) + " is of toolpath '" +
                         map.toolpath_id + "'; expected '" + toolpath_id_ + "'");
    requireShiftsWithinLayer(map, toolpath_);
  }

  bool isAbsolute() const { return !tracker_.isExtrusionRelative(); }
  bool hasOffset() const { return isAbsolute() && std::abs(offset_mm_) > kNoOffset; }

  /// Lines that are not of the part: what was changed is taken back before them.
  void copy(std::string& out) {
    const GcodeBlock& command = tracker_.command();
    const bool is_g = command.start() == LineStart::G;
    const bool has_filament = is_g && command.find('E') != nullptr;
    if (is_g && command.code() == 92 && has_filament) offset_mm_ = 0.0;
    if (is_g && command.code() >= 0 && command.code() <= 3) restore(command, out);
    if (is_g && (command.code() == 28 || command.code() == 91 || command.code() == 92))
      leaveShift(command, out);
    out += line_;
  }

  void takeShiftBack(std::string& out) {
    out += "G1 ";
    appendCoordinates(out, place_, writing_.decimals);
    out += '\n';
    shift_mm_ = 0.0;
  }

  /// Before commands after which the place of the nozzle cannot be stated any more. A nozzle that runs above
  /// the plan stays there: it would be driven into what it has just deposited.
  void leaveShift(const GcodeBlock& command, std::string& out) {
    if (command.code() == 92 && !command.hasAny("XYZ")) return;
    if (shift_mm_ < 0.0) takeShiftBack(out);
    shift_mm_ = 0.0;
  }

  void restore(const GcodeBlock& command, std::string& out) {
    if (shift_mm_ != 0.0 && command.hasAny("XYZ")) takeShiftBack(out);
    if (hasOffset() && command.find('E') != nullptr) {
      out += "G92 E";
      appendFixed(out, tracker_.motion().filament_from, kExtrusionDecimals);
      out += '\n';
      offset_mm_ = 0.0;
    }
    if (command.find('F') == nullptr && feed_ && std::abs(*feed_ - tracker_.feed()) > kSameFeed) {
      out += "G1 F";
      appendFixed(out, tracker_.feed(), kFeedDecimals);
      out += '\n';
    }
    feed_.reset();
  }

  /// F, if the machine has another one than is wanted, or the line states another.
  std::optional<double> feedWord(double wanted) {
    const PlacedWord* word = tracker_.command().find('F');
    const double present = word != nullptr ? word->value : feed_.value_or(tracker_.feed());
    const bool is_changed = wanted > 0.0 && std::abs(wanted - present) > kSameFeed;
    const double after = is_changed ? wanted : present;
    const bool differs = std::abs(after - tracker_.feed()) > kSameFeed;
    feed_ = differs ? std::optional<double>(after) : std::nullopt;
    return is_changed ? std::optional<double>(wanted) : std::nullopt;
  }

  /// A line without corrections of its own, with the nozzle shifted along the normal.
  void writePlain(std::string& out, double shift_mm) {
    const TrackedMotion& motion = tracker_.motion();
    const GcodeBlock& command = tracker_.command();
    NewWords words;
    if (hasOffset() && command.find('E') != nullptr)
      words.extrusion = motion.filament_from + motion.extrusion_mm + offset_mm_;
    words.feed = feedWord(tracker_.feed());
    Point3 shifted = place_ + shift_mm * normal_;
    if (shift_mm_ != 0.0 || shift_mm != 0.0) words.coordinates = &shifted;
    const bool moves = command.hasAny("XYZ");
    if (!moves) words.coordinates = nullptr;
    if (moves) shift_mm_ = shift_mm;
    const bool is_same = words.coordinates == nullptr && !words.extrusion && !words.feed;
    if (is_same)
      out += line_;
    else
      appendRewritten(out, command, words, writing_.decimals);
  }

  void writeMotion(std::string& out) {
    const TrackedMotion& motion = tracker_.motion();
    place_ = motion.end();
    if (!motion.deposits() || !motion.is_start_known) return writePlain(out, shiftOfTravel(motion));
    std::vector<WrittenPiece> pieces = piecesOf(motion);
    const bool is_corrected = std::any_of(pieces.begin(), pieces.end(), [](const WrittenPiece& piece) {
      return !piece.correction.isNone() || piece.end_dz_mm != 0.0;
    });
    if (!is_corrected) return writePlain(out, 0.0);
    ++report_.corrected_lines;
    report_.planned_mm += motion.extrusion_mm;
    if (motion.ends.size() > 1 && isUniform(pieces)) pieces = {joined(pieces)};
    if (pieces.size() == 1)
      writeLine(pieces.front(), out);
    else
      writeLines(pieces, out);
  }

  /// A travel to the start of a path arrives where that path is shifted.
  double shiftOfTravel(const TrackedMotion& motion) const {
    const auto start = cursor_.startingAt(motion.end());
    const PathCorrection* correction = start ? corrections_.find(start->layer, start->path) : nullptr;
    return correction != nullptr ? correctionAt(*correction, 0.0).dz_mm : 0.0;
  }

  std::vector<WrittenPiece> piecesOf(const TrackedMotion& motion) {
    double length = 0.0;
    Point3 from = motion.start;
    for (const Point3& end : motion.ends) {
      length += (end - from).norm();
      from = end;
    }
    std::vector<WrittenPiece> pieces;
    from = motion.start;
    bool is_off = false;
    for (const Point3& end : motion.ends) {
      const double pushed = motion.extrusion_mm * (end - from).norm() / length;
      const auto stretch = cursor_.follow(from, end);
      is_off |= !stretch;
      const PathCorrection* correction = stretch ? corrections_.find(stretch->layer, stretch->path) : nullptr;
      if (correction == nullptr) {
        pieces.push_back({end, pushed, {}, 0.0});
      } else {
        double done = 0.0;
        for (const CorrectedPiece& piece : correctedPieces(*correction, *stretch, writing_.split_change)) {
          done += piece.share;
          pieces.push_back(
              {from + std::min(1.0, done) * (end - from), pushed * piece.share, piece.mean, piece.end_dz_mm});
        }
        pieces.back().end = end;
      }
      from = end;
    }
    if (is_off) ++report_.off_path_lines;
    return pieces;
  }

  bool isUniform(const std::vector<WrittenPiece>& pieces) const {
    const PointCorrection& first = pieces.front().correction;
    return std::all_of(pieces.begin(), pieces.end(), [&](const WrittenPiece& piece) {
      return std::abs(piece.correction.amount - first.amount) <= writing_.split_change &&
             std::abs(piece.correction.speed - first.speed) <= writing_.split_change &&
             piece.end_dz_mm == 0.0;
    });
  }

  static WrittenPiece joined(const std::vector<WrittenPiece>& pieces) {
    WrittenPiece whole = pieces.back();
    whole.pushed = 0.0;
    PointCorrection sum;
    for (const WrittenPiece& piece : pieces) {
      whole.pushed += piece.pushed;
      sum.amount += piece.pushed * piece.correction.amount;
      sum.speed += piece.pushed * piece.correction.speed;
    }
    whole.correction = {sum.amount / whole.pushed, sum.speed / whole.pushed, 0.0};
    return whole;
  }

  /// Value of E; what its last decimal does not hold is carried on.
  double extrusionWord(const WrittenPiece& piece) {
    const double wanted = piece.pushed * (1.0 + piece.correction.amount);
    report_.corrected_mm += wanted;
    filament_ += piece.pushed;
    offset_mm_ += wanted - piece.pushed;
    if (isAbsolute()) return filament_ + offset_mm_;
    const double value = roundedExtrusion(wanted + owed_mm_);
    owed_mm_ += wanted - value;
    return value;
  }

  void writeLine(const WrittenPiece& piece, std::string& out) {
    filament_ = tracker_.motion().filament_from;
    NewWords words;
    words.extrusion = extrusionWord(piece);
    words.feed = feedWord(tracker_.feed() * (1.0 + piece.correction.speed));
    const Point3 shifted = piece.end + piece.end_dz_mm * normal_;
    if (piece.end_dz_mm != 0.0 || shift_mm_ != 0.0) words.coordinates = &shifted;
    shift_mm_ = piece.end_dz_mm;
    appendRewritten(out, tracker_.command(), words, writing_.decimals);
  }

  void writeLines(const std::vector<WrittenPiece>& pieces, std::string& out) {
    const GcodeBlock& command = tracker_.command();
    const bool has_return = !command.text().empty() && command.text().back() == '\r';
    filament_ = tracker_.motion().filament_from;
    bool is_first = true;
    for (const WrittenPiece& piece : pieces) {
      const bool is_last = &piece == &pieces.back();
      out += "G1 ";
      appendCoordinates(out, piece.end + piece.end_dz_mm * normal_, writing_.decimals);
      out += " E";
      appendFixed(out, extrusionWord(piece), kExtrusionDecimals);
      appendPieceFeed(tracker_.feed() * (1.0 + piece.correction.speed), is_first, out);
      shift_mm_ = piece.end_dz_mm;
      if (is_last) out += command.text().substr(command.wordsEnd());
      if (!is_last && has_return) out += '\r';
      if (!is_last) out += '\n';
      if (!is_first) ++report_.added_lines;
      is_first = false;
    }
  }

  /// The first of several lines states the line's own F, the others what differs from the one before.
  void appendPieceFeed(double wanted, bool is_first, std::string& out) {
    const bool is_stated = is_first && tracker_.command().find('F') != nullptr;
    const double present = feed_.value_or(tracker_.feed());
    if (!is_stated && std::abs(wanted - present) <= kSameFeed) return;
    out += " F";
    appendFixed(out, wanted, kFeedDecimals);
    feed_ = wanted;
    if (std::abs(wanted - tracker_.feed()) <= kSameFeed) feed_.reset();
  }

  CorrectionsByPath corrections_;
  DepositCursor cursor_;
  ProgramTracker tracker_;
  CorrectionWriting writing_;
  Point3 normal_;
  const Toolpath& toolpath_;
  std::string toolpath_id_;
  CorrectionReport report_;
  std::string_view line_;
  Point3 place_ = Point3::Zero();  ///< where the program thinks the nozzle is
  double filament_ = 0.0;          ///< value of E in the program, within a line
  double offset_mm_ = 0.0;         ///< of E where it is absolute
  double owed_mm_ = 0.0;           ///< by rounding, where it is relative
  double shift_mm_ = 0.0;          ///< of the nozzle along the normal
  std::optional<double> feed_;     ///< [mm/min] of the machine, where it is not the program's
};

ProgramCorrector::ProgramCorrector(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                                   const CorrectionWriting& writing)
    : writer_(std::make_unique<Writer>(toolpath, maps, writing)) {}

ProgramCorrector::~ProgramCorrector() = default;

void ProgramCorrector::add(const CorrectionMap& map) { writer_->add(map); }

void ProgramCorrector::trim(const CorrectionMap& map) { writer_->trim(map); }

void ProgramCorrector::read(std::string_view line, std::size_t number, std::string& out) {
  writer_->read(line, number, out);
}

const CorrectionReport& ProgramCorrector::report() const { return writer_->report(); }

CorrectedProgram correctedProgram(std::string_view program, const Toolpath& toolpath,
                                  const std::vector<CorrectionMap>& maps, const CorrectionWriting& writing,
                                  const std::vector<LaterMap>& trims) {
  ProgramCorrector corrector(toolpath, maps, writing);
  CorrectedProgram corrected;
  corrected.text.reserve(program.size() + program.size() / 8);
  std::size_t number = 0;
  auto trim = trims.begin();
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    ++number;
    for (; trim != trims.end() && trim->from_line <= number; ++trim) corrector.trim(trim->map);
    corrector.read(program.substr(begin, end - begin), number, corrected.text);
    if (end < program.size()) corrected.text += '\n';
    begin = end + 1;
  }
  corrected.report = corrector.report();
  return corrected;
}

}  // namespace lamina
