#include "scenarios/datasets/poses_table.h"

#include <string_view>

#include "models/angles.h"
#include "scenarios/util/csv_writer.h"

namespace touchdown::datasets {
namespace {

using estimator::PoseChoice;

void AddEllipse(util::CsvWriter& table, const estimator::Overlay::Ellipse* ellipse) {
  if (ellipse == nullptr) {
    table.Empty(3);
    return;
  }
  table << ellipse->semi_axes.x() << ellipse->semi_axes.y() << models::RadToDeg(ellipse->angle);
}

void AddBox(util::CsvWriter& table, const std::optional<estimator::PixelBox>& box) {
  if (!box) {
    table.Empty(4);
    return;
  }
  table << box->u << box->v << box->width << box->height;
}

}  // namespace

std::string PosesCsv(std::span<const FootageEstimate> estimates, const models::TimeBase& time) {
  util::CsvWriter table(
      "frame,source,t_s,status,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,pad_u_px,pad_v_px,"
      "ellipse_a_px,ellipse_b_px,ellipse_angle_deg,box_x_px,box_y_px,box_w_px,box_h_px");
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const FootageEstimate& estimate = estimates[i];
    const estimator::FrameResult& result = estimate.result;
    table << i;
    table << estimate.source;
    estimate.mid_exposure ? table << time.ToSeconds(*estimate.mid_exposure) : table.Empty(1);
    table << estimator::ReasonOrStatus(result.status, result.reason);
    result.pose ? table.Pose(result.pose->X_WB) : table.Empty(6);
    table.Pixel(result.pad_px);
    AddEllipse(table, result.overlay.FindEllipse("ring_outer"));
    AddBox(table, result.ring_box);
    table.EndLine();
  }
  return table.Take();
}

std::string ChoicesCsv(std::span<const FootageEstimate> estimates) {
  util::CsvWriter table("frame,source,reason,chosen_angle_deg,other_angle_deg,chosen_residual_mm,other_residual_mm");
  constexpr double kMillimetersPerMeter = 1000.0;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const std::optional<PoseChoice>& choice = estimates[i].result.choice;
    if (!choice) continue;
    table << i;
    table << estimates[i].source << Name(choice->reason);
    if (choice->reason == PoseChoice::Reason::kArtwork) {
      table.Empty(2) << kMillimetersPerMeter * choice->chosen << kMillimetersPerMeter * choice->other;
    } else {
      (table << models::RadToDeg(choice->chosen) << models::RadToDeg(choice->other)).Empty(2);
    }
    table.EndLine();
  }
  return table.Take();
}

runner::Trajectory PosesTrajectory(std::span<const FootageEstimate> estimates, const models::TimeBase& time) {
  runner::Trajectory trajectory;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const FootageEstimate& estimate = estimates[i];
    if (estimate.result.status != estimator::FrameStatus::kOk) continue;
    const models::Tick tick = estimate.mid_exposure.value_or(static_cast<models::Tick>(i) * time.ticks_per_s);
    trajectory.emplace(tick, estimate.result.pose.value().X_WB);
  }
  return trajectory;
}

}  // namespace touchdown::datasets
