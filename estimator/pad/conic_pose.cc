#include "estimator/pad/conic_pose.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace touchdown::estimator::pad {

std::optional<std::array<CirclePose, 2>> PosesOfCircle(const Eigen::Matrix3d& conic, double radius_m) {
  if (!conic.allFinite()) return std::nullopt;
  const double scale = conic.cwiseAbs().maxCoeff();
  if (scale == 0.0) return std::nullopt;

  Eigen::Matrix3d Q = conic / scale;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Q);
  if (eigen.eigenvalues()(1) < 0.0) {
    Q = -Q;
    eigen.compute(Q);
  }
  // Eigen sorts eigenvalues in increasing order: lambda_3 < 0 < lambda_1 <= lambda_2.
  const double lambda3 = eigen.eigenvalues()(0), lambda1 = eigen.eigenvalues()(1), lambda2 = eigen.eigenvalues()(2);
  constexpr double kSmallest = 1e-14;
  if (!(lambda3 < -kSmallest && lambda1 > kSmallest)) return std::nullopt;
  const Eigen::Vector3d u3 = eigen.eigenvectors().col(0), u2 = eigen.eigenvectors().col(2);

  const double along_u2 = std::sqrt(std::max(0.0, (lambda2 - lambda1) / (lambda2 - lambda3)));
  const double along_u3 = std::sqrt((lambda1 - lambda3) / (lambda2 - lambda3));
  const double z0 = radius_m / std::sqrt(-lambda2 * lambda3);

  std::array<CirclePose, 2> poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double s1 = i == 0 ? 1.0 : -1.0;
    Eigen::Vector3d n = s1 * along_u2 * u2 + along_u3 * u3;                             // Eq. 8
    Eigen::Vector3d t = z0 * (s1 * lambda3 * along_u2 * u2 + lambda2 * along_u3 * u3);  // Eq. 9
    if (n.z() > 0.0) n = -n;                                                            // Eq. 10
    if (t.z() < 0.0) t = -t;                                                            // Eq. 11
    if (!(t.z() > 0.0)) return std::nullopt;
    poses[i] = {n.normalized(), t};
  }
  return poses;
}

}  // namespace touchdown::estimator::pad
