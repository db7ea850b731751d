#pragma once

#include <Eigen/Core>

#include <gtest/gtest.h>

namespace devo_evo
{
inline void expectNear(const Eigen::Vector3d& expected, const Eigen::Vector3d& actual, double tolerance)
{
  EXPECT_LE((actual - expected).lpNorm<Eigen::Infinity>(), tolerance)
      << "expected (" << expected.transpose() << "), got (" << actual.transpose() << ")";
}
}  // namespace devo_evo
