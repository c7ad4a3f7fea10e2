#include "estimator/make_estimator.h"

#include <functional>
#include <utility>

#include "estimator/paper/paper_estimator.h"
#include "models/error.h"

namespace touchdown::estimator {
namespace {

using Maker = std::function<std::unique_ptr<Estimator>(const EstimatorConfig&, const EstimatorSetup&)>;

std::unique_ptr<Estimator> MakePaperEstimator(const EstimatorConfig& config, const EstimatorSetup& setup) {
  PaperEstimatorConfig paper;
  paper.edges.contour_points = config.contour_points;
  return std::make_unique<PaperEstimator>(setup, paper);
}

const std::vector<std::pair<std::string, Maker>>& Makers() {
  static const std::vector<std::pair<std::string, Maker>> makers{{"paper", MakePaperEstimator}};
  return makers;
}

}  // namespace

std::vector<std::string> EstimatorNames() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : Makers()) names.push_back(name);
  return names;
}

std::unique_ptr<Estimator> MakeEstimator(const EstimatorConfig& config, const EstimatorSetup& setup) {
  for (const auto& [name, maker] : Makers()) {
    if (name == config.name) return maker(config, setup);
  }
  std::string known;
  for (const std::string& name : EstimatorNames()) known += (known.empty() ? "" : ", ") + name;
  throw InputError("unknown estimator '" + config.name + "'; there is: " + known);
}

}  // namespace touchdown::estimator
