#pragma once

#include "Extract/CellVolumes.h"

#include <Eigen/Dense>

#include <vector>

namespace strata
{
/// What the materials, by number, lack in all over the cells of a complex.
Eigen::VectorXd missingVolumes(const CellVolumes& volumes, std::int32_t cellCount, int materialCount);

/// What the materials, by number, have too little because fractions too small for a region of their own went to the
/// cell's other materials, over all cells of a grid. The sum is 0.
Eigen::VectorXd droppedVolumes(const CellVolumes& volumes, const MixedRegion& region, Progress& progress);

/// By how much each material's value must rise everywhere for it to gain the volumes `wanted`, to first order.
Eigen::VectorXd rises(const CellVolumes& volumes, std::int32_t cellCount, const Eigen::VectorXd& wanted);
}
