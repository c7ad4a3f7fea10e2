#pragma once

#include <memory>
#include <string>
#include <vector>

#include "estimator/estimator_setup.h"
#include "estimator/loosely_coupled.h"
#include "estimator/paper/paper_options.h"
#include "estimator/state_estimator.h"
#include "models/describe.h"

namespace touchdown::estimator {

/// The strategy by its name, and the options of every strategy, of which those of the named one apply.
struct EstimatorConfig {
  std::string name = "paper";
  paper::PaperOptions paper;
  LooselyCoupledConfig filters;  ///< Of the strategies that are a VisionEstimator within filters: `paper`.

  /// Throws InputError for a name that is not among EstimatorNames(); the message lists them.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, EstimatorConfig& config);

/// The names that MakeEstimator knows.
std::vector<std::string> EstimatorNames();

/// Throws InputError for a config that is not valid, and for a camera or a pad that the estimator cannot work with.
std::unique_ptr<StateEstimator> MakeEstimator(const EstimatorConfig& config, const EstimatorSetup& setup);

}  // namespace touchdown::estimator
