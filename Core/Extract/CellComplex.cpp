#include "Extract/CellComplex.h"

#include "Model/Errors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

namespace strata
{
namespace
{
/// Builds a complex cell by cell: each face belongs to the first of its two cells that takes part.
class ComplexBuilder
{
public:
  ComplexBuilder(const GridTopology& topology, std::vector<Index> cells, Progress& progress) :
    topology_(topology), progress_(progress)
  {
    complex_.cells = std::move(cells);
    localCell_.assign(static_cast<std::size_t>(topology.cellCount()), CellComplex::none);
    for (std::size_t c = 0; c < complex_.cells.size(); ++c)
    {
      localCell_[complex_.cells[c]] = static_cast<std::int32_t>(c);
    }
  }

  CellComplex build()
  {
    numberNodes();
    countFaces();
    fillFaces();
    placeVertices();
    return std::move(complex_);
  }

private:
  template<typename Visit>
  void forEachCell(const Visit& visit)
  {
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, complex_.cellCount(), 256), [&](const auto& range) {
      progress_.check();
      CellFaces faces;
      for (std::int32_t c = range.begin(); c < range.end(); ++c)
      {
        topology_.faces(complex_.cells[c], faces);
        visit(c, faces);
      }
    });
  }

  void numberNodes()
  {
    localNode_.assign(static_cast<std::size_t>(topology_.pointCount()), CellComplex::none);
    std::vector<Index> corners;
    for (Index cell : complex_.cells)
    {
      topology_.corners(cell, corners);
      for (Index corner : corners)
      {
        localNode_[corner] = 0;
      }
    }
    for (std::size_t point = 0; point < localNode_.size(); ++point)
    {
      if (localNode_[point] == 0)
      {
        localNode_[point] = complex_.nodeCount();
        complex_.nodes.push_back(static_cast<Index>(point));
      }
    }
  }

  /// Whether a cell's face is listed with the cell, not with its neighbour.
  bool owns(std::int32_t cell, Index neighbour) const
  {
    return neighbour < 0 || localCell_[neighbour] == CellComplex::none || localCell_[neighbour] > cell;
  }

  void countFaces()
  {
    ownedStart_.assign(complex_.cells.size() + 1, 0);
    cornerStart_.assign(complex_.cells.size() + 1, 0);
    complex_.cellFaceStart.assign(complex_.cells.size() + 1, 0);
    forEachCell([this](std::int32_t c, const CellFaces& faces) {
      complex_.cellFaceStart[c + 1] = faces.count();
      for (std::int32_t f = 0; f < faces.count(); ++f)
      {
        if (owns(c, faces.neighbours[f]))
        {
          ++ownedStart_[c + 1];
          cornerStart_[c + 1] += faces.start[f + 1] - faces.start[f];
        }
      }
    });
    for (std::size_t c = 0; c < complex_.cells.size(); ++c)
    {
      complex_.cellFaceStart[c + 1] += complex_.cellFaceStart[c];
      ownedStart_[c + 1] += ownedStart_[c];
      cornerStart_[c + 1] += cornerStart_[c];
    }
    complex_.cellFaces.resize(static_cast<std::size_t>(complex_.cellFaceStart.back()));
    complex_.faceCells.resize(static_cast<std::size_t>(ownedStart_.back()));
    complex_.faceStart.assign(complex_.faceCells.size() + 1, 0);
    complex_.faceCorners.resize(static_cast<std::size_t>(cornerStart_.back()));
  }

  void fillFaces()
  {
    forEachCell([this](std::int32_t c, const CellFaces& faces) {
      std::int32_t next = ownedStart_[c];
      std::int32_t nextCorner = cornerStart_[c];
      for (std::int32_t f = 0; f < faces.count(); ++f)
      {
        CellComplex::OrientedFace& oriented = complex_.cellFaces[complex_.cellFaceStart[c] + f];
        if (!owns(c, faces.neighbours[f]))
        {
          oriented.face = findInNeighbour(faces, f);
          continue;
        }
        oriented.face = next;
        complex_.faceCells[next] = orderedCells(complex_.cells[c], faces.neighbours[f]);
        for (std::int32_t i = faces.start[f]; i < faces.start[f + 1]; ++i)
        {
          complex_.faceCorners[nextCorner++] = localNode_[faces.corners[i]];
        }
        complex_.faceStart[++next] = nextCorner;
      }
    });
  }

  static std::array<Index, 2> orderedCells(Index cell, Index neighbour)
  {
    return neighbour < 0 ? std::array<Index, 2>{ cell, -1 }
                         : std::array<Index, 2>{ std::min(cell, neighbour), std::max(cell, neighbour) };
  }

  static std::vector<Index> sortedCorners(const CellFaces& faces, std::int32_t f)
  {
    std::vector<Index> corners(faces.corners.begin() + faces.start[f], faces.corners.begin() + faces.start[f + 1]);
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  std::int32_t findInNeighbour(const CellFaces& faces, std::int32_t f) const
  {
    const std::int32_t owner = localCell_[faces.neighbours[f]];
    CellFaces others;
    topology_.faces(faces.neighbours[f], others);
    const std::vector<Index> corners = sortedCorners(faces, f);
    std::int32_t candidate = ownedStart_[owner];
    for (std::int32_t g = 0; g < others.count(); ++g)
    {
      if (!owns(owner, others.neighbours[g]))
      {
        continue;
      }
      if (sortedCorners(others, g) == corners)
      {
        return candidate;
      }
      ++candidate;
    }
    // Three cells share the face.
    throw InvalidInput("a face of cell " + std::to_string(faces.neighbours[f]) + " has more than one neighbour");
  }

  /// Sums run by ascending native id, so that they don't depend on how a cell lists its corners.
  void placeVertices()
  {
    complex_.positions.resize(static_cast<std::size_t>(complex_.vertexCount()));
    for (std::int32_t n = 0; n < complex_.nodeCount(); ++n)
    {
      complex_.positions[n] = topology_.point(complex_.nodes[n]);
    }
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, complex_.faceCount(), 1024), [this](const auto& range) {
      std::vector<std::int32_t> corners;
      for (std::int32_t f = range.begin(); f < range.end(); ++f)
      {
        corners.assign(complex_.faceCorners.begin() + complex_.faceStart[f],
          complex_.faceCorners.begin() + complex_.faceStart[f + 1]);
        complex_.positions[complex_.faceVertex(f)] = mean(corners);
      }
    });
    forEachCell([this](std::int32_t c, const CellFaces& faces) {
      complex_.positions[complex_.cellVertex(c)] = topology_.center(complex_.cells[c]);
      orientFaces(c, faces.count());
    });
  }

  void orientFaces(std::int32_t c, std::int32_t count)
  {
    std::vector<Vector> corners;
    for (std::int32_t f = 0; f < count; ++f)
    {
      CellComplex::OrientedFace& oriented = complex_.cellFaces[complex_.cellFaceStart[c] + f];
      corners.clear();
      for (std::int32_t i = complex_.faceStart[oriented.face]; i < complex_.faceStart[oriented.face + 1]; ++i)
      {
        corners.push_back(complex_.positions[complex_.faceCorners[i]]);
      }
      oriented.reversed = sixfoldVolume(corners, complex_.positions[complex_.cellVertex(c)]) < 0.0;
    }
  }

  Vector mean(std::vector<std::int32_t>& corners) const
  {
    std::sort(corners.begin(), corners.end());
    Vector sum = Vector::Zero();
    for (std::int32_t corner : corners)
    {
      sum += complex_.positions[corner];
    }
    return sum / static_cast<double>(corners.size());
  }

  const GridTopology& topology_;
  Progress& progress_;
  CellComplex complex_;
  std::vector<std::int32_t> localCell_;
  std::vector<std::int32_t> localNode_;
  std::vector<std::int32_t> ownedStart_;
  std::vector<std::int32_t> cornerStart_;
};
}

CellComplex makeCellComplex(const GridTopology& topology, std::vector<Index> cells, Progress& progress)
{
  return ComplexBuilder(topology, std::move(cells), progress).build();
}
}
