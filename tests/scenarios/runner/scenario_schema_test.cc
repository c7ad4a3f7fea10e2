#include "scenarios/runner/scenario_schema.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace touchdown::runner {
namespace {

/// Converts to the type of any field in the initializer of an aggregate.
struct AnyField {
  template <typename T>
  operator T() const;  // NOLINT: it must convert silently. Never called.
};

template <typename T, std::size_t... I>
constexpr bool HasFields(std::index_sequence<I...>) {
  return requires { T{((void)I, AnyField{})...}; };
}

/// Number of fields of a struct, which is the largest number of initializers that it accepts.
template <typename T, std::size_t N = 48>
constexpr std::size_t FieldCount() {
  if constexpr (HasFields<T>(std::make_index_sequence<N>())) {
    return N;
  } else {
    return FieldCount<T, N - 1>();
  }
}

/// Counts the keys of a struct. A section counts as one key.
class KeyCounter : public models::ConfigVisitor {
 public:
  std::size_t count = 0;

  void Number(const models::Key&, double&, const models::Unit&, const models::Range&) override { ++count; }
  void OptionalNumber(const models::Key&, std::optional<double>&, const models::Unit&, const models::Range&) override {
    ++count;
  }
  void Numbers(const models::Key&, const std::vector<double*>&, const models::Unit&, const models::Range&) override {
    ++count;
  }
  void Integer64(const models::Key&, std::int64_t&, const models::Range&) override { ++count; }
  void Boolean(const models::Key&, bool&) override { ++count; }
  void Text(const models::Key&, std::string&) override { ++count; }
  void Choice(const models::Key&, int&, std::span<const std::string_view>) override { ++count; }
  void Section(const models::Key&, const models::SectionFile&,
               const std::function<void(models::ConfigVisitor&)>&) override {
    ++count;
  }
  void List(const models::Key&, std::size_t, const std::function<void(std::size_t)>&,
            const std::function<void(models::ConfigVisitor&, std::size_t)>&) override {
    ++count;
  }
  void Check(std::string_view, const std::function<void()>&) override {}
};

template <typename T>
std::size_t KeyCount() {
  T value;
  KeyCounter counter;
  Describe(counter, value);
  return counter.count;
}

template <typename T>
class SchemaOf : public ::testing::Test {};

using Structs =
    ::testing::Types<models::TimeBase, models::Vehicle, models::Rotor, models::Mounting, models::LandingGear,
                     models::CameraModel, models::LandingPad, sim::CameraConfig, sim::ImuConfig,
                     sim::TrackingSystemConfig, sim::RangeFinderConfig, sim::HandConfig, sim::SceneConfig, sim::Sun,
                     sim::VibrationConfig, estimator::paper::PaperOptions, estimator::AttitudeEstimatorConfig,
                     estimator::PoseFilterConfig, controller::GuidanceConfig, controller::PositionControllerConfig,
                     controller::AttitudeControllerConfig, controller::FlightControllerConfig, Criterion>;
TYPED_TEST_SUITE(SchemaOf, Structs);

TYPED_TEST(SchemaOf, HasKeyForEveryField) { EXPECT_EQ(KeyCount<TypeParam>(), FieldCount<TypeParam>()); }

TEST(SchemaOfScenario, HasSeparateKeysForTheFiltersOfTheEstimator) {
  constexpr auto kSensors = std::tuple_size_v<LoggedSensors::Configs>;  // Keys of the field `sensors`.
  EXPECT_EQ(KeyCount<Scenario>(), FieldCount<Scenario>() - 1 + kSensors + 2);
  EXPECT_EQ(KeyCount<estimator::EstimatorConfig>() + 1, FieldCount<estimator::EstimatorConfig>());
}

TEST(SchemaOfCalibration, HasKeyForEveryField) {
  Calibration all{.camera_model = models::CameraModel(), .camera = models::Mounting(), .imu = models::Mounting()};
  KeyCounter counter;
  Describe(counter, all);
  EXPECT_EQ(counter.count, FieldCount<Calibration>());
}

TEST(SchemaOfWorld, OmitsOnlyPaintTextures) {
  EXPECT_EQ(KeyCount<sim::WorldConfig>() + 1, FieldCount<sim::WorldConfig>());
}

}  // namespace
}  // namespace touchdown::runner
