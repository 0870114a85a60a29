#pragma once

#include "Outflow.h"

#include <array>
#include <vector>

namespace impact
{
/// One directional step of a row of cells, and the work space for it; one object serves many rows.
///
/// Lagrange and remap: pressure relaxation in mixed cells, acoustic Riemann problems at the faces, motion with
/// the faces (momentum, energy in total-energy form, volume, deviator), and geometric volume-of-fluid fluxes back
/// to the cells' places. Only the part of a row that is not at rest is touched.
class LineSweep
{
public:
  LineSweep(Simulation& simulation, int axis, double timeStep);

  /// Advances the row through the cell `index`, whose component along the axis is 0. Returns the largest
  /// (|u| + c) / h that was seen.
  double advance(const std::array<int, 3>& index);

  /// Mass that left the box or was deleted as dust, of all rows so far.
  const std::array<double, 2>& lostMass() const { return lostMass_; }

private:
  /// The two sides of a face: velocity and traction along the axis and across, in the order of directions_.
  struct FaceSide
  {
    double velocity[3], traction[3], impedance[2];
  };

  // Cells -2 .. N+1 of the row and faces 0 .. N; face i lies before cell i.
  Cell& cell(int i) { return cells_[i + 2]; }
  CellState& state(int i) { return states_[i + 2]; }
  bool full(int i) { return cell(i).solid() > 1 - 1e-9; }
  double traction(int i, int q);

  bool findActivePart();
  void loadCells();
  void mirrorCell(int ghost, int source);
  FaceSide reconstruct(int face, int side);
  void solveFace(int face);
  void moveCell(int i);
  void changeVolumes(int i, double heat, double gap);
  void deform(int i, double gap);
  void computeFluxes(int i);
  void remapCell(int i);
  void settle(Cell& cell, double kinetic);

  Simulation& simulation_;
  const int axis_;
  const int length_;
  const double ratio_; ///< time step over cell size
  const std::array<int, 3> directions_;
  std::array<double, 2> lostMass_ = { 0, 0 };

  std::array<int, 3> index_;
  std::size_t base_ = 0;
  int first_ = 0, last_ = -1; ///< the active part of the row
  double fastest_ = 0;
  std::vector<Cell> cells_;
  std::vector<CellState> states_;
  std::vector<Flux> fluxes_;
  std::vector<double> volumes_;       ///< after the motion, of the cell as a whole
  std::vector<double> displacements_; ///< of faces, in cells
  std::vector<std::array<double, 3>> faceTractions_, faceVelocities_;
};
}
