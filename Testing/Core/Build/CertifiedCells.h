#pragma once

#include "Build/CellFunctions.h"
#include "Build/HierarchyBuilder.h"
#include "Select/Front.h"
#include "Support/SphereCase.h"

#include <random>

namespace strata::test
{
/// A hierarchy with certified errors, grown where asked for.
class CertifiedCells
{
public:
  CertifiedCells(std::shared_ptr<const NativeData> native, const Interfaces& interfaces, const ErrorBounds& bounds,
    int maximumLevel, NativeElements elements = NativeElements::Cells)
  {
    BuildOptions options;
    options.nativeElements = elements;
    Progress progress;
    builder_ = std::make_unique<HierarchyBuilder>(std::move(native), interfaces, options, progress);
    const Criterion criterion(bounds, {}, maximumLevel);
    Front front(hierarchy(), false);
    for (;;)
    {
      const std::vector<DiamondId> missing =
        front.advance(hierarchy(), criterion, 1.0, std::numeric_limits<Index>::max());
      if (missing.empty())
      {
        return;
      }
      builder_->split(missing, progress);
    }
  }

  const Hierarchy& hierarchy() const { return builder_->hierarchy(); }
  Index cellCount() const { return static_cast<Index>(hierarchy().cells.size()); }

private:
  std::unique_ptr<HierarchyBuilder> builder_;
};

/// Barycentric weights of a random point of a tetrahedron, often on its faces and edges.
inline std::array<double, 4> randomWeights(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(1e-12, 1.0);
  std::array<double, 4> weights;
  double sum = 0.0;
  while (sum == 0.0)
  {
    for (double& weight : weights)
    {
      weight = random() % 3 == 0 ? 0.0 : -std::log(unit(random));
      sum += weight;
    }
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

inline Vector pointAt(const std::array<Vector, 4>& corners, const std::array<double, 4>& weights)
{
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] + weights[3] * corners[3];
}

/// Cells of random levels, each level's cells as likely.
inline std::vector<CellId> randomCells(const Hierarchy& hierarchy, std::size_t count, unsigned seed)
{
  std::vector<std::vector<CellId>> byLevel;
  for (Index c = 0; c < static_cast<Index>(hierarchy.cells.size()); ++c)
  {
    const std::size_t level = hierarchy.cell(CellId(c)).level;
    byLevel.resize(std::max(byLevel.size(), level + 1));
    byLevel[level].push_back(CellId(c));
  }
  std::mt19937 random(seed);
  std::vector<CellId> result;
  while (result.size() < count)
  {
    const std::vector<CellId>& cells = byLevel[random() % byLevel.size()];
    result.push_back(cells[random() % cells.size()]);
  }
  return result;
}
}
