// Replaces bag_file.cc and flight_bag.cc in builds without the ROS bag libraries.
#include <fmt/format.h>

#include "models/error.h"
#include "scenarios/datasets/bag_file.h"
#include "scenarios/datasets/flight_bag.h"

namespace touchdown::datasets {
namespace {

[[noreturn]] void ThrowNoBagSupport(const std::filesystem::path& file) {
  throw InputError(fmt::format("bag {}: built without ROS bag support; packages/test.txt lists the required packages",
                               file.filename().string()));
}

}  // namespace

struct FlightBag::Impl {};
FlightBag::FlightBag(const runner::Scenario& /*scenario*/, const std::filesystem::path& file) {
  ThrowNoBagSupport(file);
}
FlightBag::~FlightBag() = default;
void FlightBag::OnImu(const models::ImuSample& /*sample*/, bool /*at_rest*/) {}
void FlightBag::OnFrame(const models::CameraFrame& /*frame*/, const estimator::FrameResult& /*estimate*/,
                        const runner::FrameRecord& /*record*/) {}
void FlightBag::Finish(const runner::FlightLog& /*log*/) {}

struct BagFile::Impl {
  FootageMetadata metadata;
};
BagFile::BagFile(const std::filesystem::path& file, const std::vector<std::string>& /*topics*/) {
  ThrowNoBagSupport(file);
}
BagFile::~BagFile() = default;
const FootageMetadata& BagFile::metadata() const { return impl_->metadata; }
std::optional<FootageFrame> BagFile::Next() { return std::nullopt; }

}  // namespace touchdown::datasets
