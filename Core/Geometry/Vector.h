#pragma once

#include <Eigen/Core>

namespace strata
{
/// A point or a direction in space, in the data's own length unit.
using Vector = Eigen::Vector3d;
}
