#include "Extract/HangingNodes.h"

#include "Extract/FaceRemainder.h"
#include "Extract/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace strata
{
namespace
{
struct Face
{
  Index cell;
  std::int32_t number;
  std::vector<Index> corners;
  Vector center;
  Vector area; ///< points out of the cell
  Box box;
  std::vector<std::size_t> parts;         ///< the faces that replace it
  std::vector<std::array<Index, 3>> rest; ///< what the parts don't cover
  bool taken = false;                     ///< replaces a part of another face

  double tolerance() const { return hangingTolerance * box.diagonal(); }
};

class HangingNodes
{
public:
  HangingNodes(const GridTopology& topology, const std::vector<UnmatchedFace>& unmatched, Progress& progress) :
    topology_(topology), progress_(progress), split_(topology, unmatched, progress)
  {
    for (const UnmatchedFace& face : unmatched)
    {
      progress.check();
      faces_.push_back(describe(face));
    }
  }

  void join(ReplacedCells& cells, Warnings& warnings)
  {
    coverFaces(warnings);
    replaceCells(cells);
  }

private:
  Face describe(const UnmatchedFace& unmatched) const
  {
    CellFaces faces;
    topology_.faceCorners(unmatched.cell, faces);
    Face face;
    face.cell = unmatched.cell;
    face.number = unmatched.face;
    face.corners.assign(
      faces.corners.begin() + faces.start[unmatched.face], faces.corners.begin() + faces.start[unmatched.face + 1]);
    face.center.setZero();
    for (Index corner : face.corners)
    {
      face.center += topology_.point(corner) / static_cast<double>(face.corners.size());
      face.box.add(topology_.point(corner));
    }
    face.area.setZero();
    for (std::size_t i = 0; i < face.corners.size(); ++i)
    {
      const Vector a = topology_.point(face.corners[i]) - face.center;
      face.area += 0.5 * a.cross(topology_.point(face.corners[(i + 1) % face.corners.size()]) - face.center);
    }
    if (face.area.dot(face.center - topology_.center(face.cell)) < 0.0)
    {
      std::reverse(face.corners.begin(), face.corners.end());
      face.area = -face.area;
    }
    return face;
  }

  /// Whether a point lies in a face, which is taken for flat and convex.
  bool contains(const Face& face, const Vector& point) const
  {
    const Vector normal = face.area.normalized();
    if (std::abs(normal.dot(point - face.center)) > face.tolerance())
    {
      return false;
    }
    for (std::size_t i = 0; i < face.corners.size(); ++i)
    {
      const Vector a = topology_.point(face.corners[i]);
      const Vector along = (topology_.point(face.corners[(i + 1) % face.corners.size()]) - a).normalized();
      if (normal.dot(along.cross(point - a)) < -face.tolerance())
      {
        return false;
      }
    }
    return true;
  }

  bool covers(const Face& coarse, const Face& fine) const
  {
    return fine.cell != coarse.cell && !fine.taken && fine.area.dot(coarse.area) < 0.0 &&
           fine.area.norm() < (1.0 + hangingTolerance) * coarse.area.norm() &&
           std::all_of(fine.corners.begin(), fine.corners.end(),
             [&](Index corner) { return contains(coarse, topology_.point(corner)); });
  }

  void coverFaces(Warnings& warnings)
  {
    std::vector<Vector> centers;
    for (const Face& face : faces_)
    {
      centers.push_back(face.center);
    }
    const PointTree tree(std::move(centers));
    std::size_t failures = 0;
    Index first = 0;
    for (Face& face : faces_)
    {
      progress_.check();
      std::vector<std::size_t> parts;
      Box box = face.box;
      box.lower.array() -= face.tolerance();
      box.upper.array() += face.tolerance();
      tree.forEachIn(box, [&](std::size_t i) {
        if (covers(face, faces_[i]))
        {
          parts.push_back(i);
        }
      });
      std::sort(parts.begin(), parts.end());
      if (parts.empty() || sameLoop(face, parts))
      {
        continue;
      }
      const auto rest = triangulateRegion(topology_, boundaryOfRest(face, parts), face.area);
      if (!rest || !fills(face, parts, *rest))
      {
        first = failures++ == 0 ? face.cell : first;
        continue;
      }
      for (std::size_t part : parts)
      {
        faces_[part].taken = true;
      }
      face.parts = std::move(parts);
      face.rest = *rest;
    }
    if (failures > 0)
    {
      warnings.push_back("A face of cell " + std::to_string(first) +
                         (failures > 1 ? " and " + std::to_string(failures - 1) + " others are" : " is") +
                         " crossed by faces of other cells: surfaces end there");
    }
  }

  /// Whether a face meets one that differs by points on its edges alone: inserting those is all it needs.
  bool sameLoop(const Face& face, const std::vector<std::size_t>& parts) const
  {
    const auto sorted = [&](const Face& f) {
      std::vector<Index> loop = split_.withHangingPoints(f.corners);
      std::sort(loop.begin(), loop.end());
      return loop;
    };
    return parts.size() == 1 && sorted(faces_[parts[0]]) == sorted(face);
  }

  /// The directed edges that bound what the parts don't cover of a face: where these cover it, there are none.
  std::vector<std::pair<Index, Index>> boundaryOfRest(const Face& face, const std::vector<std::size_t>& parts) const
  {
    std::map<SplitEdges::Edge, int> balance;
    const auto add = [&](const Face& f) {
      const std::vector<Index> loop = split_.withHangingPoints(f.corners);
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Index a = loop[i];
        const Index b = loop[(i + 1) % loop.size()];
        balance[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
      }
    };
    add(face);
    for (std::size_t part : parts)
    {
      add(faces_[part]);
    }
    std::vector<std::pair<Index, Index>> result;
    for (const auto& [edge, count] : balance)
    {
      result.insert(result.end(), static_cast<std::size_t>(std::max(count, 0)), edge);
      result.insert(result.end(), static_cast<std::size_t>(std::max(-count, 0)), { edge.second, edge.first });
    }
    return result;
  }

  /// Whether parts and rest together are as large as the face.
  bool fills(
    const Face& face, const std::vector<std::size_t>& parts, const std::vector<std::array<Index, 3>>& rest) const
  {
    double area = 0.0;
    for (std::size_t part : parts)
    {
      area += faces_[part].area.norm();
    }
    for (const std::array<Index, 3>& t : rest)
    {
      const Vector origin = topology_.point(t[0]);
      area += 0.5 * (topology_.point(t[1]) - origin).cross(topology_.point(t[2]) - origin).norm();
    }
    return std::abs(area - face.area.norm()) <= 100.0 * hangingTolerance * face.area.norm();
  }

  /// The cells that have a split edge or a covered face, ascending.
  std::vector<Index> affectedCells() const
  {
    std::vector<Index> result;
    std::vector<Index> a;
    std::vector<Index> b;
    for (const SplitEdges::Edge& edge : split_.edges())
    {
      progress_.check();
      topology_.cellsAround(edge.first, a);
      topology_.cellsAround(edge.second, b);
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    }
    for (const Face& face : faces_)
    {
      if (!face.parts.empty())
      {
        result.push_back(face.cell);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void replaceCells(ReplacedCells& cells)
  {
    CellFaces faces;
    std::vector<Index> centerCorners;
    for (Index cell : affectedCells())
    {
      progress_.check();
      topology_.faceCorners(cell, faces);
      topology_.centerCorners(cell, centerCorners);
      CellFaces result;
      for (std::int32_t f = 0; f < faces.count(); ++f)
      {
        if (const Face* covered = findCovered(cell, f))
        {
          for (std::size_t part : covered->parts)
          {
            addFace(faces_[part].corners, result);
          }
          for (const std::array<Index, 3>& triangle : covered->rest)
          {
            addFace({ triangle.begin(), triangle.end() }, result);
          }
          continue;
        }
        addFace({ faces.corners.begin() + faces.start[f], faces.corners.begin() + faces.start[f + 1] }, result);
      }
      cells.set(cell, centerCorners, std::move(result));
    }
  }

  const Face* findCovered(Index cell, std::int32_t number) const
  {
    const auto found = std::lower_bound(faces_.begin(), faces_.end(), std::make_pair(cell, number),
      [](const Face& face, const auto& key) { return std::make_pair(face.cell, face.number) < key; });
    return found != faces_.end() && found->cell == cell && found->number == number && !found->parts.empty() ? &*found
                                                                                                            : nullptr;
  }

  void addFace(const std::vector<Index>& corners, CellFaces& faces) const
  {
    const std::vector<Index> loop = split_.withHangingPoints(corners);
    faces.corners.insert(faces.corners.end(), loop.begin(), loop.end());
    faces.start.push_back(static_cast<std::int32_t>(faces.corners.size()));
    faces.neighbours.push_back(-1);
  }

  const GridTopology& topology_;
  Progress& progress_;
  SplitEdges split_;
  std::vector<Face> faces_; ///< ascending by cell and number
};
}

void joinHangingNodes(const GridTopology& topology, const std::vector<UnmatchedFace>& unmatched, ReplacedCells& cells,
  Warnings& warnings, Progress& progress)
{
  HangingNodes(topology, unmatched, progress).join(cells, warnings);
}
}
