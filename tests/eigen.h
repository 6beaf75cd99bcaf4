// Our vectors as Eigen's and back, for oracles that factor matrices or are written in Eigen.
#pragma once

#include <Eigen/Geometry>

#include "core/quat.h"

namespace carom::test {

inline Eigen::Vector3d eigen(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Matrix3d eigen(const Mat3& m) { return Eigen::Map<const Eigen::Matrix3d>(m.data()); }
inline Vec3 plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Quat plain(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

}  // namespace carom::test
