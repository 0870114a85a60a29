#pragma once

#include "Measure/Measure.h"
#include "Support/PointData.h"
#include "Support/RepresentationCube.h"
#include "Support/TriangulatedShapes.h"

#include <algorithm>
#include <map>

namespace strata::test
{
inline const MaterialId A(0);
inline const MaterialId B(1);
inline const MaterialId C(2);

inline Box unitBox()
{
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  return box;
}

/// Adds an interface; equal corners become one point.
inline void addSurface(Interfaces& interfaces, MaterialId positive, MaterialId negative, const Triangles& triangles)
{
  Interfaces::Surface surface{ positive, negative, {} };
  for (const auto& triangle : triangles)
  {
    std::array<std::int32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto found = std::find(interfaces.points.begin(), interfaces.points.end(), triangle[i]);
      corners[i] = static_cast<std::int32_t>(found - interfaces.points.begin());
      if (found == interfaces.points.end())
      {
        interfaces.points.push_back(triangle[i]);
      }
    }
    surface.triangles.push_back(corners);
  }
  interfaces.surfaces.push_back(surface);
}

/// The part x = `at` of the unit box; its normal points along +x into `positive`.
inline Triangles planeAcrossX(double at, int n)
{
  return parallelogram({ at, 0, 0 }, Vector::UnitY(), Vector::UnitZ(), n);
}

/// Width of measured Hausdorff intervals in units of the diagonal.
inline constexpr double hausdorffTolerance = 1e-3;

inline RepresentationErrors measure(
  const Mesh& mesh, const NativeData& native, const Interfaces& interfaces, const OriginalVolumes& volumes)
{
  Progress progress;
  return measureRepresentation(view(mesh), native, interfaces, volumes, progress, hausdorffTolerance);
}

inline const FieldErrorReport& fieldReport(const RepresentationErrors& errors, FieldId field, MaterialId m)
{
  return *std::find_if(errors.fields.begin(), errors.fields.end(),
    [&](const FieldErrorReport& report) { return report.field == field && report.material == m; });
}
}
