// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/nsga2.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "front_archive.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/random.hpp"
#include "lamina/optimisation/pareto.hpp"
#include "variation.hpp"

namespace lamina {
namespace {

/// Progress of one batch of evaluations within a search.
class BatchProgress final : public Progress {
 public:
  BatchProgress(Progress& outer, double begin, double end) : outer_(outer), begin_(begin), end_(end) {}
  void report(const std::string&, double fraction) override {
    outer_.report("search", begin_ + (end_ - begin_) * fraction);
  }
  bool isCancelled() const override { return outer_.isCancelled(); }

 private:
  Progress& outer_;
  double begin_;
  double end_;
};

/// Responses as costs, and back.
std::vector<double> turned(const Goals& goals, std::vector<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (goals.objectives[i].sense == Sense::Maximise) values[i] = -values[i];
  return values;
}

/// One that survived.
struct Individual {
  std::size_t evaluation = 0;  ///< index
  std::size_t rank = 0;
  double crowding = 0.0;
};

class FrontFinder {
 public:
  FrontFinder(const SearchProblem& problem, const Nsga2Settings& settings, Progress& progress)
      : problem_(problem),
        settings_(settings),
        progress_(progress),
        names_(problem.evaluator.responseNames()),
        random_(static_cast<std::uint64_t>(settings.seed)),
        reference_(turned(problem.goals, settings.reference)) {}

  void begin() {
    evaluate(firstPoints());
    select();
  }

  void advance() {
    std::vector<Parent> parents;
    parents.reserve(population_.size());
    for (const Individual& one : population_)
      parents.push_back({&found_.evaluations[one.evaluation].point, one.rank, one.crowding});
    evaluate(vary(problem_.space, settings_, parents, random_));
    select();
  }

  const Generation& record(int index) {
    Generation generation;
    generation.index = index;
    generation.evaluations = static_cast<int>(found_.evaluations.size());
    generation.failed = failed_;
    const std::vector<std::size_t> front = distinct(populationFront());
    for (const std::size_t i : front) generation.front.push_back(found_.evaluations[i]);
    std::vector<std::vector<double>> costs;
    for (const std::size_t i : archive_.members()) costs.push_back(scores_[i].costs);
    if (!reference_.empty()) generation.hypervolume = hypervolume(costs, reference_);
    found_.generations.push_back(std::move(generation));
    return found_.generations.back();
  }

  FrontSearch found() && {
    for (const std::size_t i : distinct(archive_.members())) found_.front.push_back(found_.evaluations[i]);
    found_.reference = turned(problem_.goals, reference_);
    return std::move(found_);
  }

 private:
  std::vector<DesignPoint> firstPoints() {
    const auto size = static_cast<std::size_t>(settings_.population);
    std::vector<DesignPoint> points = settings_.first_points;
    points.resize(std::min(points.size(), size));
    if (settings_.takes_corners)
      for (DesignPoint& corner : cornersOf(problem_.space, std::min(size / 2, size - points.size()), random_))
        points.push_back(std::move(corner));
    while (points.size() < size) points.push_back(randomPoint(problem_.space, random_));
    return points;
  }

  /// Adds the points to all evaluations, and to the population.
  void evaluate(const std::vector<DesignPoint>& points) {
    const auto total = static_cast<double>(evaluationsOf(settings_));
    const auto before = static_cast<double>(found_.evaluations.size());
    BatchProgress batch(progress_, before / total, (before + static_cast<double>(points.size())) / total);
    throwIfCancelled(progress_, "search");
    for (Evaluation& evaluation : problem_.evaluator.evaluate(points, {}, batch)) {
      refuseUnusable(evaluation);
      if (!isEvaluated(evaluation)) ++failed_;
      scores_.push_back(scoreOf(problem_.goals, names_, evaluation));
      if (isFeasible(scores_.back())) archive_.add(found_.evaluations.size(), scores_.back().costs);
      population_.push_back({found_.evaluations.size(), 0, 0.0});
      found_.evaluations.push_back(std::move(evaluation));
    }
  }

  /// An objective that is no number cannot be compared.
  void refuseUnusable(Evaluation& evaluation) const {
    if (!isEvaluated(evaluation)) return;
    for (const Objective& objective : problem_.goals.objectives) {
      const double response = evaluation.responses.at(responseIndex(names_, objective.response));
      if (std::isfinite(response)) continue;
      evaluation.error =
          "objective " + objective.response + " is " + numberText(response) + "; must be finite";
      evaluation.responses.clear();
      return;
    }
  }

  /// Keeps the best of the population: whole fronts, and of the last one those with most room.
  void select() {
    std::vector<Score> scores;
    scores.reserve(population_.size());
    for (const Individual& one : population_) scores.push_back(scores_[one.evaluation]);
    const auto size = static_cast<std::size_t>(settings_.population);
    std::vector<Individual> kept;
    kept.reserve(size);
    const std::vector<Front> fronts = frontsOf(scores);
    for (std::size_t rank = 0; rank < fronts.size() && kept.size() < size; ++rank) {
      const Front front = roomiest(scores, fronts[rank], size - kept.size());
      // Those that go leave room to those that stay.
      const std::vector<double> crowding = crowdingOf(scores, front);
      for (std::size_t i = 0; i < front.size(); ++i)
        kept.push_back({population_[front[i]].evaluation, rank, crowding[i]});
    }
    population_ = std::move(kept);
    if (reference_.empty()) setReference();
  }

  /// At most so many of a front, those with most room around them.
  static Front roomiest(const std::vector<Score>& scores, const Front& front, std::size_t most) {
    if (front.size() <= most) return front;
    const std::vector<double> crowding = crowdingOf(scores, front);
    std::vector<std::size_t> order(front.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return crowding[a] > crowding[b]; });
    Front chosen;
    for (std::size_t i = 0; i < most; ++i) chosen.push_back(front[order[i]]);
    return chosen;
  }

  /// The worst of each cost among all feasible points so far: of the first generation that has one.
  void setReference() {
    for (const Score& score : scores_) {
      if (!isFeasible(score)) continue;
      if (reference_.empty()) reference_ = score.costs;
      for (std::size_t i = 0; i < reference_.size(); ++i)
        reference_[i] = std::max(reference_[i], score.costs[i]);
    }
  }

  /// Feasible evaluations of the first front.
  std::vector<std::size_t> populationFront() const {
    std::vector<std::size_t> front;
    for (const Individual& one : population_)
      if (one.rank == 0 && isFeasible(scores_[one.evaluation])) front.push_back(one.evaluation);
    return front;
  }

  /// Ascending by costs, each point once.
  std::vector<std::size_t> distinct(std::vector<std::size_t> front) const {
    const auto key = [&](std::size_t i) { return std::tie(scores_[i].costs, found_.evaluations[i].point); };
    std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    const auto isSame = [&](std::size_t a, std::size_t b) {
      return found_.evaluations[a].point == found_.evaluations[b].point;
    };
    front.erase(std::unique(front.begin(), front.end(), isSame), front.end());
    return front;
  }

  const SearchProblem& problem_;
  const Nsga2Settings& settings_;
  Progress& progress_;
  const std::vector<std::string>& names_;
  Random random_;
  std::vector<double> reference_;  ///< as costs
  std::vector<Score> scores_;      ///< of all evaluations
  std::vector<Individual> population_;
  FrontArchive archive_;
  int failed_ = 0;
  FrontSearch found_;
};

}  // namespace

std::int64_t evaluationsOf(const Nsga2Settings& settings) {
  return settings.population + settings.generations * static_cast<std::int64_t>(offspringOf(settings));
}

void validate(const SearchProblem& problem, const Nsga2Settings& settings) {
  validate(problem);
  Nsga2Settings described = settings;
  SettingsSchema schema;
  describe(schema, described);
  schema.validate();
  if (settings.generations > 0 && offspringOf(settings) == 0)
    throw InvalidConfig(
        "nsga2.crossover_share and nsga2.mutation_share make no new points; one must be greater");
  for (const DesignPoint& point : settings.first_points) requireWithin(problem.space, point);
  const std::size_t objectives = problem.goals.objectives.size();
  if (!settings.reference.empty() && settings.reference.size() != objectives)
    throw InvalidConfig("reference of the hypervolume with " + std::to_string(settings.reference.size()) +
                        " numbers; there are " + std::to_string(objectives) + " objectives");
}

FrontSearch searchFront(const SearchProblem& problem, const Nsga2Settings& settings,
                        const GenerationListener& listener, Progress& progress) {
  validate(problem, settings);
  FrontFinder finder(problem, settings, progress);
  finder.begin();
  for (int index = 0; index <= settings.generations; ++index) {
    if (index > 0) finder.advance();
    const Generation& generation = finder.record(index);
    if (listener) listener(generation);
  }
  return std::move(finder).found();
}

}  // namespace lamina
