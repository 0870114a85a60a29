#include "Conversion/InputSurfaces.h"

#include "Conversion/OrientSurface.h"
#include "Conversion/ValueConversion.h"
#include "Conversion/Weld.h"

#include "Geometry/Box.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace strata::conversion
{
namespace
{
using Triangle = SurfaceTriangle;
using Pair = std::pair<std::int32_t, std::int32_t>;

std::string label(const NamedSurface& surface)
{
  return surface.name.empty() ? "The surface" : "The surface '" + surface.name + "'";
}

MaterialId materialOf(const std::string& name, const Materials& materials, const NamedSurface& surface)
{
  std::vector<std::string> known;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    if (materials[m].name == name)
    {
      return MaterialId(static_cast<std::int64_t>(m));
    }
    known.push_back(materials[m].name);
  }
  throw InvalidInput(
    label(surface) + " names the material '" + name + "', which the data don't have. Materials: " + listed(known));
}

/// Splits `<positive>|<negative>`.
Pair pairFromName(const NamedSurface& surface, const Materials& materials)
{
  const std::size_t bar = surface.name.find('|');
  if (bar == std::string::npos)
  {
    throw InvalidInput(label(surface) +
                       " doesn't say which materials it parts: it needs the cell arrays 'positive_material' and "
                       "'negative_material', or a name '<positive>|<negative>'");
  }
  return { materialOf(surface.name.substr(0, bar), materials, surface).value,
    materialOf(surface.name.substr(bar + 1), materials, surface).value };
}

/// The pair of each cell of a surface.
class Pairs
{
public:
  Pairs(const NamedSurface& surface, vtkPolyData* triangles, const Materials& materials)
  {
    vtkDataArray* positive = triangles->GetCellData()->GetArray(names::positive);
    vtkDataArray* negative = triangles->GetCellData()->GetArray(names::negative);
    if (!positive || !negative)
    {
      all_ = pairFromName(surface, materials);
      return;
    }
    positive_ = integersOf(positive);
    negative_ = integersOf(negative);
    numbers_ = numberedMaterials(surface, materials);
    for (std::size_t cell = 0; cell < positive_.size(); ++cell)
    {
      check(positive_[cell], surface, cell);
      check(negative_[cell], surface, cell);
    }
  }

  Pair operator()(std::size_t cell) const
  {
    return positive_.empty() ? all_
                             : Pair{ numbers_[static_cast<std::size_t>(positive_[cell])],
                                 numbers_[static_cast<std::size_t>(negative_[cell])] };
  }

private:
  /// Numbers in the surface's arrays mean its own `material_names`, if it has them, else the data's.
  static std::vector<std::int32_t> numberedMaterials(const NamedSurface& surface, const Materials& materials)
  {
    const std::vector<std::string> own = stringsOf(surface.surface->GetFieldData(), names::materials);
    std::vector<std::int32_t> numbers;
    for (std::size_t m = 0; m < (own.empty() ? materials.size() : own.size()); ++m)
    {
      const auto place = std::find_if(materials.begin(), materials.end(),
        [&](const Material& material) { return !own.empty() && material.name == own[m]; });
      numbers.push_back(own.empty()                ? static_cast<std::int32_t>(m)
                        : place == materials.end() ? -1
                                                   : static_cast<std::int32_t>(place - materials.begin()));
    }
    return numbers;
  }

  void check(std::int64_t material, const NamedSurface& surface, std::size_t cell) const
  {
    if (material < 0 || material >= static_cast<std::int64_t>(numbers_.size()) ||
        numbers_[static_cast<std::size_t>(material)] < 0)
    {
      throw InvalidInput(label(surface) + " has the material number " + std::to_string(material) + " in cell " +
                         std::to_string(cell) + ", which the data don't have");
    }
  }

  Pair all_;
  std::vector<std::int64_t> positive_;
  std::vector<std::int64_t> negative_;
  std::vector<std::int32_t> numbers_;
};

/// A surface's triangles with all its attributes; quads and strips are cut. Lines and vertices are dropped
/// beside triangles and refused alone.
vtkSmartPointer<vtkPolyData> triangulated(const NamedSurface& surface, Warnings& warnings)
{
  vtkPolyData* input = surface.surface;
  const Index faces = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  const Index others = input->GetNumberOfLines() + input->GetNumberOfVerts();
  if (faces == 0 && others > 0)
  {
    throw InvalidInput(label(surface) + " has lines or vertices only; an interface is made of triangles");
  }
  if (faces == 0)
  {
    warnings.push_back(label(surface) + " is empty and ignored");
  }
  else if (others > 0)
  {
    warnings.push_back(label(surface) + " has " + std::to_string(others) + " lines or vertices, which are ignored");
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(input);
  filter->PassLinesOff();
  filter->PassVertsOff();
  filter->Update();
  return filter->GetOutput();
}

void checkConnectivity(const NamedSurface& surface)
{
  const Index pointCount = surface.surface->GetNumberOfPoints();
  for (vtkCellArray* cells : { surface.surface->GetPolys(), surface.surface->GetStrips() })
  {
    if (!cells || cells->GetNumberOfCells() == 0)
    {
      continue;
    }
    for (const std::int64_t point : integersOf(cells->GetConnectivityArray()))
    {
      if (point < 0 || point >= pointCount)
      {
        throw InvalidInput(
          label(surface) + " uses point " + std::to_string(point) + " of " + std::to_string(pointCount));
      }
    }
  }
}

void checkFinite(const NamedSurface& surface, const std::vector<Vector>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!points[i].allFinite())
    {
      throw InvalidInput("Point " + std::to_string(i) + " of " + label(surface).substr(4) + " is not finite");
    }
  }
}

std::vector<Triangle> trianglesOf(vtkPolyData* surface)
{
  std::vector<Triangle> triangles;
  if (surface->GetNumberOfPolys() > 0)
  {
    const std::vector<std::int64_t> corners = integersOf(surface->GetPolys()->GetConnectivityArray());
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    {
      triangles.push_back({ corners[i], corners[i + 1], corners[i + 2] });
    }
  }
  return triangles;
}

/// All surfaces' points one after another, and triangles by pair.
struct Collected
{
  std::vector<Vector> points;
  std::map<Pair, std::vector<Triangle>> triangles;
};

void collect(const NamedSurface& surface, const Materials& materials, Collected& collected, Warnings& warnings)
{
  checkConnectivity(surface);
  const vtkSmartPointer<vtkPolyData> data = triangulated(surface, warnings);
  const std::vector<Vector> points = positionsOf(data->GetPoints());
  std::vector<Triangle> triangles = trianglesOf(data);
  if (triangles.empty())
  {
    return;
  }
  checkFinite(surface, points);
  orient(data, points, triangles);
  const Pairs pairs(surface, data, materials);
  const auto first = static_cast<Index>(collected.points.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& c = triangles[t];
    const Pair pair = pairs(t);
    if (pair.first == pair.second)
    {
      throw InvalidInput(label(surface) + " parts the material '" +
                         materials[static_cast<std::size_t>(pair.first)].name + "' from itself");
    }
    collected.triangles[pair].push_back({ first + c[0], first + c[1], first + c[2] });
  }
  collected.points.insert(collected.points.end(), points.begin(), points.end());
}

/// The same triangle with its lowest corner first.
Triangle turned(Triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Welds the points; triangles that lose a corner by it are dropped, those that repeat another one, and points that
/// none uses.
Interfaces welded(const Collected& collected, Warnings& warnings)
{
  Index doubled = 0;
  Box box;
  for (const Vector& point : collected.points)
  {
    box.add(point);
  }
  const std::vector<Index> same = weld(collected.points, weldTolerance * box.diagonal());
  std::vector<std::int32_t> place(collected.points.size(), -1);
  Interfaces result;
  for (const auto& [pair, triangles] : collected.triangles)
  {
    Interfaces::Surface surface{ MaterialId(pair.first), MaterialId(pair.second), {} };
    std::set<Triangle> seen;
    for (const Triangle& triangle : triangles)
    {
      const Index a = same[static_cast<std::size_t>(triangle[0])];
      const Index b = same[static_cast<std::size_t>(triangle[1])];
      const Index c = same[static_cast<std::size_t>(triangle[2])];
      const Vector& p = collected.points[static_cast<std::size_t>(a)];
      const Vector area =
        (collected.points[static_cast<std::size_t>(b)] - p).cross(collected.points[static_cast<std::size_t>(c)] - p);
      if (a == b || b == c || c == a || area.squaredNorm() == 0.0)
      {
        continue;
      }
      if (!seen.insert(turned({ a, b, c })).second)
      {
        ++doubled;
        continue;
      }
      std::array<std::int32_t, 3> corners{};
      int k = 0;
      for (const Index corner : { a, b, c })
      {
        std::int32_t& position = place[static_cast<std::size_t>(corner)];
        if (position < 0)
        {
          position = static_cast<std::int32_t>(result.points.size());
          result.points.push_back(collected.points[static_cast<std::size_t>(corner)]);
        }
        corners[static_cast<std::size_t>(k++)] = position;
      }
      surface.triangles.push_back(corners);
    }
    if (!surface.triangles.empty())
    {
      result.surfaces.push_back(std::move(surface));
    }
  }
  if (doubled > 0)
  {
    warnings.push_back(std::to_string(doubled) + " triangles of the interfaces repeat another one and are left out");
  }
  return result;
}
}

Interfaces readInterfaces(const std::vector<NamedSurface>& surfaces, const Materials& materials, Warnings& warnings)
{
  Collected collected;
  for (const NamedSurface& surface : surfaces)
  {
    collect(surface, materials, collected, warnings);
  }
  return welded(collected, warnings);
}
}
