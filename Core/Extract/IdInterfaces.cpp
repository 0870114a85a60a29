#include "Extract/IdInterfaces.h"

#include "Extract/Patches.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr Index blockSize = 4096;

/// Corner points of one face, the lowest id first.
struct Face
{
  std::vector<Vector> corners;
  Vector center;
};

Face gather(const GridTopology& topology, const CellFaces& faces, std::int32_t f)
{
  std::vector<Index> ids(faces.corners.begin() + faces.start[f], faces.corners.begin() + faces.start[f + 1]);
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  Face face;
  for (Index id : ids)
  {
    face.corners.push_back(topology.point(id));
  }
  std::sort(ids.begin(), ids.end());
  face.center.setZero();
  for (Index id : ids)
  {
    face.center += topology.point(id);
  }
  face.center /= static_cast<double>(ids.size());
  return face;
}

/// Whether all corners lie in one plane, up to rounding.
bool isFlat(const Face& face)
{
  Vector normal = Vector::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < face.corners.size(); ++i)
  {
    const Vector a = face.corners[i] - face.center;
    normal += a.cross(face.corners[(i + 1) % face.corners.size()] - face.center);
    size = std::max(size, a.norm());
  }
  normal.normalize();
  return std::all_of(face.corners.begin(), face.corners.end(),
    [&](const Vector& corner) { return std::abs(normal.dot(corner - face.center)) <= 1e-12 * size; });
}

/// Whether no triangle of the fan from the first corner is degenerate, as it may be where points hang on edges.
bool canFan(const Face& face)
{
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
  {
    const Vector a = face.corners[i] - face.corners[0];
    const Vector b = face.corners[i + 1] - face.corners[0];
    if (a.cross(b).norm() <= 1e-9 * (a.squaredNorm() + b.squaredNorm()))
    {
      return false;
    }
  }
  return true;
}

void addFace(SurfacePatch& patch, std::uint8_t front, std::uint8_t back, const Face& face)
{
  const std::size_t n = face.corners.size();
  std::vector<std::int32_t> corners;
  for (const Vector& corner : face.corners)
  {
    corners.push_back(patch.addPoint(corner));
  }
  if (isFlat(face) && canFan(face))
  {
    for (std::size_t i = 1; i + 1 < n; ++i)
    {
      patch.addTriangle(front, back, { corners[0], corners[i], corners[i + 1] });
    }
    return;
  }
  const std::int32_t center = patch.addPoint(face.center);
  for (std::size_t i = 0; i < n; ++i)
  {
    patch.addTriangle(front, back, { center, corners[i], corners[(i + 1) % n] });
  }
}

class IdExtraction
{
public:
  IdExtraction(const Simulation& simulation, const GridTopology& topology, const Boundary& boundary) :
    ids_(simulation.materialIds), topology_(topology), boundary_(boundary)
  {}

  void addCell(Index cell, CellFaces& faces, SurfacePatch& patch) const
  {
    topology_.faces(cell, faces);
    for (std::int32_t f = 0; f < faces.count(); ++f)
    {
      const Index neighbour = faces.neighbours[f];
      const bool outside = boundary_.facesOutside(faces, f);
      const bool between = neighbour > cell && ids_[neighbour] != ids_[cell];
      if (outside || between)
      {
        Face face = gather(topology_, faces, f);
        if (sixfoldVolume(face.corners, topology_.center(cell)) < 0.0)
        {
          std::reverse(face.corners.begin() + 1, face.corners.end());
        }
        const auto other = outside ? *boundary_.outside() : static_cast<std::uint8_t>(ids_[neighbour]);
        addFace(patch, other, static_cast<std::uint8_t>(ids_[cell]), face);
      }
    }
  }

private:
  const std::vector<std::int32_t>& ids_;
  const GridTopology& topology_;
  const Boundary& boundary_;
};
}

ExtractedInterfaces extractFromIds(
  const Simulation& simulation, const GridTopology& topology, const Boundary& boundary, Progress& progress)
{
  const IdExtraction extraction(simulation, topology, boundary);
  const Index blockCount = (topology.cellCount() + blockSize - 1) / blockSize;
  std::vector<SurfacePatch> patches(static_cast<std::size_t>(blockCount));
  std::vector<double> volumes(static_cast<std::size_t>(topology.cellCount()), 0.0);
  tbb::parallel_for(Index{ 0 }, blockCount, [&](Index b) {
    progress.check();
    CellFaces faces;
    for (Index cell = b * blockSize; cell < std::min((b + 1) * blockSize, topology.cellCount()); ++cell)
    {
      if (!topology.hidden(cell))
      {
        extraction.addCell(cell, faces, patches[b]);
        volumes[cell] = topology.volume(cell);
      }
    }
  });
  ExtractedInterfaces result;
  result.interfaces = joinPatches(patches, progress);
  result.volumes.resize(simulation.materials.size());
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    if (volumes[cell] > 0.0)
    {
      result.volumes[simulation.materialIds[cell]].given += volumes[cell];
    }
  }
  for (VolumeReport& report : result.volumes)
  {
    report.reconstructed = report.given;
  }
  return result;
}
}
