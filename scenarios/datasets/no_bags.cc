// In place of bag_file.cc and flight_bag.cc where the libraries of ROS bags are not there.
#include <fmt/format.h>

#include "models/error.h"
#include "scenarios/datasets/bag_file.h"
#include "scenarios/datasets/flight_bag.h"

namespace touchdown::datasets {
namespace {

[[noreturn]] void Refuse(const std::filesystem::path& file) {
  throw InputError(fmt::format("bag {}: built without the ROS packages for bags; packages/test.txt lists them",
                               file.filename().string()));
}

}  // namespace

struct FlightBag::Impl {};
FlightBag::FlightBag(const runner::Scenario& /*scenario*/, const std::filesystem::path& file) { Refuse(file); }
FlightBag::~FlightBag() = default;
void FlightBag::OnImu(const models::ImuSample& /*sample*/, bool /*at_rest*/) {}
void FlightBag::OnFrame(const models::CameraFrame& /*frame*/, const estimator::FrameResult& /*estimate*/,
                        const runner::FrameRecord& /*record*/) {}
void FlightBag::Finish(const runner::FlightLog& /*log*/) {}

struct BagFile::Impl {
  FootageFacts facts;
};
BagFile::BagFile(const std::filesystem::path& file, const std::vector<std::string>& /*topics*/) { Refuse(file); }
BagFile::~BagFile() = default;
const FootageFacts& BagFile::facts() const { return impl_->facts; }
std::optional<FootageFrame> BagFile::Next() { return std::nullopt; }

}  // namespace touchdown::datasets
