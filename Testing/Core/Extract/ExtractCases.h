#pragma once

#include "Extract/Extract.h"

#include "Support/FractionsOfBox.h"
#include "Support/FractionsOnGrids.h"
#include "SurfaceChecks.h"

#include <gtest/gtest.h>

namespace strata::test
{
inline ExtractedInterfaces extract(const Simulation& simulation, bool correct = true, bool gather = true)
{
  Progress progress;
  ExtractOptions options;
  options.volumeCorrection = correct;
  options.gatherSmearedFractions = gather;
  return extractInterfaces(simulation, options, progress);
}

using Distance = std::function<double(const Vector&)>;

/// Two materials: the first where a signed distance is negative.
inline FractionsOf insideOf(const Distance& distance)
{
  return [=](const Box& box) {
    const double inside = fractionInside(box, distance, 4);
    return std::vector<double>{ inside, 1.0 - inside };
  };
}

inline Distance sphere(const Vector& center, double radius)
{
  return [=](const Vector& x) { return (x - center).norm() - radius; };
}

/// Nested regions: material m is inside the m-th distance and outside the former ones; the last is the rest.
inline FractionsOf nested(const std::vector<Distance>& distances)
{
  return [=](const Box& box) {
    std::vector<double> fractions;
    double covered = 0.0;
    for (const Distance& distance : distances)
    {
      const double inside = fractionInside(box, distance, 4);
      fractions.push_back(inside - covered);
      covered = inside;
    }
    fractions.push_back(1.0 - covered);
    return fractions;
  };
}

/// The regions in which each of several linear functions of x is the smallest, by sampling n^3 points of a box.
inline FractionsOf smallestOf(const std::vector<Vector>& directions, const Vector& center, int n)
{
  return [=](const Box& box) {
    std::vector<double> fractions(directions.size(), 0.0);
    for (int i = 0; i < n * n * n; ++i)
    {
      const Vector at((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
      const Vector x = box.lower + at.cwiseProduct(box.size()) - center;
      std::size_t best = 0;
      for (std::size_t m = 1; m < directions.size(); ++m)
      {
        best = directions[m].dot(x) < directions[best].dot(x) ? m : best;
      }
      fractions[best] += 1.0 / (n * n * n);
    }
    return fractions;
  };
}

/// Largest error of a cell's volumes, as a part of the cell (all cells of one size).
inline double largestCellError(const ExtractedInterfaces& result, double cellVolume)
{
  double largest = 0.0;
  for (const VolumeReport& report : result.volumes)
  {
    largest = std::max(largest, report.largestError / cellVolume);
  }
  return largest;
}

/// Mean distance of the points from the true surface.
inline double meanDistance(const Interfaces& interfaces, const Distance& distance)
{
  double sum = 0.0;
  for (const Vector& point : interfaces.points)
  {
    sum += std::abs(distance(point));
  }
  return sum / static_cast<double>(interfaces.points.size());
}

/// The surface between two materials; fails the test if there is none.
inline const Interfaces::Surface& surfaceBetween(const Interfaces& interfaces, int positive, int negative)
{
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    if (surface.positive.value == positive && surface.negative.value == negative)
    {
      return surface;
    }
  }
  static const Interfaces::Surface none{};
  ADD_FAILURE() << "no surface between " << positive << " and " << negative;
  return none;
}
}
