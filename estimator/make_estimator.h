#pragma once

#include <memory>
#include <string>
#include <vector>

#include "estimator/estimator.h"
#include "estimator/paper/paper_options.h"
#include "models/describe.h"

namespace touchdown::estimator {

/// What a scenario may say of the estimator: its name, and the options of each strategy, of which only the named one's
/// count.
struct EstimatorConfig {
  std::string name = "paper";
  paper::PaperOptions paper;

  /// Throws InputError for a name that is not among EstimatorNames(); the message lists them.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, EstimatorConfig& config);

/// The names that MakeEstimator knows.
std::vector<std::string> EstimatorNames();

/// Throws InputError for a config that is not valid, and for a camera or a pad that the estimator cannot work with.
std::unique_ptr<Estimator> MakeEstimator(const EstimatorConfig& config, const EstimatorSetup& setup);

}  // namespace touchdown::estimator
