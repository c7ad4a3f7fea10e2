#include "scenarios/config/config_reference.h"
#include "scenarios/runner/scenario.h"
#include "scenarios/runner/scenario_schema.h"

namespace touchdown::runner {

std::vector<config::KeyRow> ScenarioReference() {
  constexpr int kVariants = 4;  // Largest number of names of a choice.
  config::ConfigReference reference;
  for (int variant = 0; variant < kVariants; ++variant) {
    Scenario scenario;
    reference.BeginVariant(variant);
    Describe(reference, scenario);
  }
  return reference.rows();
}

}  // namespace touchdown::runner
