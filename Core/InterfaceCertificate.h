#pragma once

#include "Build/HierarchyBuilder.h"
#include "Certify/InterfaceTrees.h"
#include "Geometry/CutTetrahedron.h"
#include "Model/Level.h"
#include "Model/Representation.h"
#include "Select/Criterion.h"

namespace strata
{
/// Certified distances between the original and the represented interfaces of a level, both ways and for each pair of
/// materials, cell by cell: no point of an original interface in a cell is farther than its error from the
/// represented interface of the whole mesh, and no point of the represented interface in it from the original one.
///
/// What is measured is the mesh as it would be written. From one level to the next, only cells that changed, or whose
/// surroundings did, are measured again.
class InterfaceCertificate
{
public:
  /// The builder and the trees must outlive the object.
  InterfaceCertificate(const HierarchyBuilder& builder, const InterfaceTrees& original, Criterion criterion);

  /// Measures a level, and closes its regions. `values` is the builder's hierarchy but for the values and errors at
  /// the level. An error above the criterion's bound may be too small, though not below the bound.
  void measure(const Hierarchy& values, Level& level, Progress& progress);
  /// Measures the errors above the bound to the end, and the regions' boundaries where an interface has no counterpart.
  void complete(Progress& progress);

  /// The cells of the level measured that must be split before the next is measured.
  std::vector<CellId> tooCoarse(const Hierarchy& values);
  /// Whether no cell of the level measured exceeds its bound.
  bool boundsHold() const;
  /// Whether a cell exceeds its bound that may be split: for a level of which `tooCoarse` finds no cells, one that it
  /// left alone for being small.
  bool leavesThinParts(const Hierarchy& values) const;
  double error(CellId cell) const { return recordOf(cell).error(); }
  /// Raises the errors in a mesh emitted from the level completed to those of this certificate.
  void writeErrors(Mesh& mesh) const;

private:
  struct Record
  {
    std::vector<CornerValues> distances; ///< that the represented pieces were made from
    std::vector<InterfacePiece> original;
    Vector center = Vector::Zero(); ///< of a ball round the original pieces
    double radius = 0.0;
    std::vector<InterfacePiece> represented;
    std::vector<InterfacePiece> gone; ///< represented by the level measured before, but not by this one
    double originalError = 0.0;
    double representedError = 0.0;
    double limit = 0.0; ///< what the error may be
    bool isNew = true;
    bool changed = true;

    double error() const { return originalError > representedError ? originalError : representedError; }
  };

  /// The largest distance between the original and the represented boundary of a region, either way: no larger than
  /// the errors, and finite where a pair of materials touches on one side only.
  double regionDistance(Progress& progress);
  double regionDistance(const Record& record, const RegionTrees& original, const RegionTrees& represented) const;
  /// Takes over a level; returns the pieces that are no longer represented.
  InterfaceTrees updatePieces(const Hierarchy& values, Level& level, Progress& progress);
  void updatePieces(const Hierarchy& values, const Representation& mesh, Index number, TetrahedronCut& cut);
  std::unique_ptr<Record> newRecord(const Hierarchy& values, CellId cell) const;
  /// Whether some of the surfaces may be what the original pieces of a record were near to.
  static bool mayHaveSupported(const InterfaceTrees& surfaces, const Record& record);
  bool exceedsBound(CellId cell) const { return recordOf(cell).error() > recordOf(cell).limit; }
  Record& recordOf(CellId cell) { return *records_[static_cast<std::size_t>(cell.value)]; }
  const Record& recordOf(CellId cell) const { return *records_[static_cast<std::size_t>(cell.value)]; }

  const HierarchyBuilder& builder_;
  const InterfaceTrees& original_;
  Criterion criterion_;
  double rounding_;
  std::size_t smallSplitsLeft_ = 0;
  std::vector<CellId> cells_;                    ///< of the level measured last
  std::vector<std::unique_ptr<Record>> records_; ///< [cell]; null for cells never measured
  std::unique_ptr<InterfaceTrees> represented_;
  double regionError_ = 0.0; ///< of the level completed
};
}
