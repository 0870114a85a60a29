#include "Measure/InterfaceErrors.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t verticesPerTask = 256;

/// The original interface between one pair of materials, whatever the number and orientation of its surfaces.
struct OriginalSurface
{
  MaterialId positive;
  MaterialId negative;
  std::vector<std::int32_t> vertices; ///< ascending, each once
  TriangleSoup soup;
};

std::map<MaterialPair, OriginalSurface> originalSurfaces(const Interfaces& interfaces)
{
  std::map<MaterialPair, OriginalSurface> result;
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    OriginalSurface& original = result[orderedPair(surface.positive, surface.negative)];
    if (!original.positive.valid())
    {
      original.positive = surface.positive;
      original.negative = surface.negative;
    }
    for (const auto& [a, b, c] : surface.triangles)
    {
      original.vertices.insert(original.vertices.end(), { a, b, c });
      original.soup.triangles.push_back({ interfaces.points[a], interfaces.points[b], interfaces.points[c] });
    }
  }
  for (auto& [pair, original] : result)
  {
    std::vector<std::int32_t>& vertices = original.vertices;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return result;
}

void append(const TriangleSoup& more, TriangleSoup& soup)
{
  soup.triangles.insert(soup.triangles.end(), more.triangles.begin(), more.triangles.end());
}

/// Distance of a point to the plane on which two materials are equally far away in a cell; infinite if there is none.
double distanceToPlane(const Representation& representation, std::int64_t cell,
  const TetrahedronLocator::Weights& weights, const MaterialPair& pair)
{
  const float* first = representation.distances[pair.first.value];
  const float* second = representation.distances[pair.second.value];
  if (!first || !second)
  {
    return infinity;
  }
  const std::int64_t* corners = representation.tetrahedra + 4 * cell;
  const Vector origin = representation.point(corners[0]);
  Eigen::Matrix3d edges;
  std::array<double, 4> signedDistances{};
  double atPoint = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    signedDistances[i] = static_cast<double>(second[corners[i]]) - static_cast<double>(first[corners[i]]);
    atPoint += weights[i] * signedDistances[i];
    if (i > 0)
    {
      edges.row(i - 1) = (representation.point(corners[i]) - origin).transpose();
    }
  }
  const Vector differences(signedDistances[1] - signedDistances[0], signedDistances[2] - signedDistances[0],
    signedDistances[3] - signedDistances[0]);
  const Vector gradient = edges.inverse() * differences;
  const double distance = atPoint == 0.0 ? 0.0 : std::abs(atPoint) / gradient.norm();
  return std::isfinite(distance) ? distance : infinity;
}

void measureVertices(const Representation& representation, const Interfaces& interfaces,
  const OriginalSurface& original, const TetrahedronLocator& locator, Progress& progress, InterfaceErrorReport& report)
{
  const MaterialPair pair = orderedPair(original.positive, original.negative);
  const auto count = static_cast<std::int64_t>(original.vertices.size());
  std::vector<double> distances(original.vertices.size(), infinity);
  tbb::parallel_for(
    tbb::blocked_range<std::int64_t>(0, count, verticesPerTask), [&](const tbb::blocked_range<std::int64_t>& range) {
      progress.check();
      for (std::int64_t i = range.begin(); i < range.end(); ++i)
      {
        locator.visitCells(
          interfaces.points[original.vertices[i]], [&](std::int64_t cell, const TetrahedronLocator::Weights& weights) {
            distances[i] = std::min(distances[i], distanceToPlane(representation, cell, weights, pair));
            return false;
          });
      }
    });
  report.vertices = count;
  report.missing = std::count(distances.begin(), distances.end(), infinity);
  if (count > 0)
  {
    const auto largest = std::max_element(distances.begin(), distances.end());
    report.largestVertexError = *largest;
    report.where = interfaces.points[original.vertices[largest - distances.begin()]];
  }
}
}

std::vector<InterfaceErrorReport> measureInterfaces(const Representation& representation, const Interfaces& original,
  const PairSurfaces& represented, const TetrahedronLocator& locator, double tolerance, Progress& progress)
{
  std::map<MaterialPair, OriginalSurface> originals = originalSurfaces(original);
  for (const auto& [pair, soup] : represented)
  {
    originals.insert({ pair, { pair.first, pair.second, {}, {} } });
  }
  std::vector<InterfaceErrorReport> reports;
  for (const auto& [pair, surface] : originals)
  {
    progress.update(static_cast<double>(reports.size()) / static_cast<double>(originals.size()));
    InterfaceErrorReport report;
    report.positive = surface.positive;
    report.negative = surface.negative;
    measureVertices(representation, original, surface, locator, progress, report);
    const auto found = represented.find(pair);
    report.distance =
      hausdorffDistance(surface.soup, found != represented.end() ? found->second : TriangleSoup{}, tolerance, progress);
    reports.push_back(report);
  }
  return reports;
}

std::vector<RegionErrorReport> measureRegions(const Interfaces& original, const PairSurfaces& represented,
  const std::vector<InterfaceErrorReport>& interfaces, double tolerance, Progress& progress)
{
  std::map<MaterialId, std::vector<const InterfaceErrorReport*>> interfacesOf;
  for (const InterfaceErrorReport& report : interfaces)
  {
    interfacesOf[report.positive].push_back(&report);
    interfacesOf[report.negative].push_back(&report);
  }
  const std::map<MaterialPair, OriginalSurface> originals = originalSurfaces(original);
  std::vector<RegionErrorReport> reports;
  for (const auto& [material, own] : interfacesOf)
  {
    progress.update(static_cast<double>(reports.size()) / static_cast<double>(interfacesOf.size()));
    // Most materials touch one other.
    reports.push_back({ material, own.front()->distance });
    if (own.size() > 1)
    {
      TriangleSoup before;
      TriangleSoup after;
      for (const InterfaceErrorReport* report : own)
      {
        const MaterialPair pair = orderedPair(report->positive, report->negative);
        const auto there = originals.find(pair);
        const auto here = represented.find(pair);
        append(there != originals.end() ? there->second.soup : TriangleSoup{}, before);
        append(here != represented.end() ? here->second : TriangleSoup{}, after);
      }
      reports.back().distance = hausdorffDistance(before, after, tolerance, progress);
    }
  }
  return reports;
}
}
