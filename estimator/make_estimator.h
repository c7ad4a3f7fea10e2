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

/// Name of the strategy, and the options of every strategy. Only the options of the named strategy apply.
struct EstimatorConfig {
  std::string name = "paper";
  paper::PaperOptions paper;
  LooselyCoupledConfig filters;  ///< For strategies that use LooselyCoupled: `paper`.

  /// Throws InputError when `name` is not one of EstimatorNames(); the message lists them.
  void Validate() const;
};

void Describe(models::ConfigVisitor& v, EstimatorConfig& config);

/// Names that MakeEstimator accepts.
std::vector<std::string> EstimatorNames();

/// Creates the estimator that `config` names. Throws InputError for an invalid config, camera or pad, and for a pad
/// that the estimator does not support.
std::unique_ptr<StateEstimator> MakeEstimator(const EstimatorConfig& config, const EstimatorSetup& setup);

}  // namespace touchdown::estimator
