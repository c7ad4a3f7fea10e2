// What a vehicle's own program would do with the flight libraries, as far as it goes without a camera: estimate from an
// image, and let the controller answer.
#include <cstdio>

#include "controller/flight_controller.h"
#include "estimator/make_estimator.h"
#include "models/vehicle.h"

int main() {
  const touchdown::models::Vehicle vehicle;
  const touchdown::models::TimeBase time;

  touchdown::estimator::EstimatorSetup setup;
  setup.X_BC = vehicle.X_BC();
  const auto estimator = touchdown::estimator::MakeEstimator({}, setup);
  const touchdown::models::Image blank(setup.camera.width_px, setup.camera.height_px, 200);
  const auto estimate = estimator->Estimate(blank.View(), 0, -Eigen::Vector3d::UnitZ());
  if (estimate.status == touchdown::estimator::FrameStatus::kOk) return 1;

  touchdown::controller::FlightController controller({}, vehicle, time, 200,
                                                     {{.kind = touchdown::controller::ManoeuvreKind::kTakeoff}}, false);
  const auto output = controller.Update({});
  std::printf("%s, %s\n", std::string(Name(estimate.status)).c_str(), std::string(Name(output.phase)).c_str());
  return output.rotors.speed_rad_s[0] == 0.0 ? 0 : 1;
}
