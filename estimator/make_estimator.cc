#include "estimator/make_estimator.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "estimator/paper/paper_estimator.h"
#include "models/error.h"

namespace touchdown::estimator {
namespace {

using Maker = std::function<std::unique_ptr<StateEstimator>(const EstimatorConfig&, const EstimatorSetup&)>;

std::unique_ptr<StateEstimator> MakePaperEstimator(const EstimatorConfig& config, const EstimatorSetup& setup) {
  paper::PaperEstimatorConfig paper;
  paper.search.edges.contour_points = config.paper.contour_points;
  paper.search.verify = config.paper.verify;
  return std::make_unique<LooselyCoupled>(std::make_unique<paper::PaperEstimator>(setup, paper), config.filters,
                                          setup.time, setup.R_BU);
}

const std::vector<std::pair<std::string, Maker>>& Makers() {
  static const std::vector<std::pair<std::string, Maker>> makers{{"paper", MakePaperEstimator}};
  return makers;
}

/// The maker for `name`; nullptr for an unknown name.
const Maker* FindMaker(const std::string& name) {
  const auto found = std::find_if(Makers().begin(), Makers().end(), [&](const auto& row) { return row.first == name; });
  return found == Makers().end() ? nullptr : &found->second;
}

}  // namespace

std::vector<std::string> EstimatorNames() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : Makers()) names.push_back(name);
  return names;
}

void EstimatorConfig::Validate() const {
  if (FindMaker(name) != nullptr) return;
  std::string known;
  for (const std::string& known_name : EstimatorNames()) known += (known.empty() ? "" : ", ") + known_name;
  throw InputError("unknown estimator '" + name + "'; allowed: " + known);
}

void Describe(models::ConfigVisitor& v, EstimatorConfig& c) {
  v.Text({"name", "Estimator that turns IMU samples and frames into the state of the vehicle."}, c.name);
  v.Keys({"paper", "Options of the estimator paper, the method of Yang et al."}, c.paper);
  v.Renamed("contour_points", "paper.contour_points");
  v.Check("name", [&c] { c.Validate(); });
}

std::unique_ptr<StateEstimator> MakeEstimator(const EstimatorConfig& config, const EstimatorSetup& setup) {
  config.Validate();
  return (*FindMaker(config.name))(config, setup);
}

}  // namespace touchdown::estimator
