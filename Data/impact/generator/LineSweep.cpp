#include "LineSweep.h"

#include <algorithm>
#include <cmath>

namespace impact
{
namespace
{
/// Speed (cm per microsecond) and stress (Mbar) below which a cell counts as at rest.
constexpr double quiet = 1e-6;

bool atRest(const Cell& cell, const Metals& metals)
{
  double stress = 0;
  double speed = 0;
  for (const double x : cell.velocity)
  {
    speed = std::max(speed, std::fabs(x));
  }
  for (const double x : cell.deviator)
  {
    stress = std::max(stress, std::fabs(x));
  }
  bool active = speed > quiet || stress > quiet;
  for (int k = 0; k < 2; ++k)
  {
    const double restMass = metals.material[k].density * cell.fraction[k];
    active = active || (cell.fraction[k] > 0 && std::fabs(cell.mass[k] - restMass) > 1e-5 * cell.mass[k]);
  }
  return !active;
}
}

LineSweep::LineSweep(Simulation& simulation, int axis, double timeStep) :
  simulation_(simulation), axis_(axis), length_(simulation.count[axis]),
  ratio_(timeStep / simulation.spacing[axis]), directions_{ axis, (axis + 1) % 3, (axis + 2) % 3 }, cells_(length_ + 4),
  states_(length_ + 4), fluxes_(length_ + 5), volumes_(length_ + 4), displacements_(length_ + 5),
  faceTractions_(length_ + 5), faceVelocities_(length_ + 5)
{}

double LineSweep::advance(const std::array<int, 3>& index)
{
  index_ = index;
  base_ = simulation_.cellAt(index[0], index[1], index[2]);
  if (!findActivePart())
  {
    return 0;
  }
  loadCells();
  fastest_ = 0;
  for (int face = first_; face <= last_ + 1; ++face)
  {
    solveFace(face);
  }
  for (int i = first_; i <= last_; ++i)
  {
    moveCell(i);
  }
  std::fill(fluxes_.begin() + first_, fluxes_.begin() + last_ + 2, Flux());
  for (int i = first_; i <= last_; ++i)
  {
    computeFluxes(i);
  }
  for (int k = 0; k < 2; ++k)
  {
    lostMass_[k] += last_ == length_ - 1 ? fluxes_[length_].mass[k] : 0;
    lostMass_[k] -= first_ == 0 ? fluxes_[0].mass[k] : 0;
  }
  for (int i = first_; i <= last_; ++i)
  {
    remapCell(i);
  }
  return fastest_ / simulation_.spacing[axis_];
}

bool LineSweep::findActivePart()
{
  first_ = length_;
  last_ = -1;
  for (int i = 0; i < length_; ++i)
  {
    const Cell& c = simulation_.cells[base_ + i * simulation_.stride[axis_]];
    if (c.solid() != 0 && !atRest(c, simulation_.metals))
    {
      first_ = std::min(first_, i);
      last_ = i;
    }
  }
  if (last_ < 0)
  {
    return false;
  }
  first_ = std::max(first_ - 3, 0);
  last_ = std::min(last_ + 3, length_ - 1);
  return true;
}

void LineSweep::loadCells()
{
  for (int i = std::max(first_ - 2, 0); i <= std::min(last_ + 2, length_ - 1); ++i)
  {
    cell(i) = simulation_.cells[base_ + i * simulation_.stride[axis_]];
    state(i) = relax(cell(i), simulation_.metals);
  }
  // Beyond the row: a mirror at x = 0 and y = 0, void elsewhere.
  for (int distance = 1; distance <= 2; ++distance)
  {
    if (first_ - distance < 0)
    {
      mirrorCell(-distance, distance - 1);
    }
    if (last_ + distance >= length_)
    {
      cell(last_ + distance) = Cell();
      state(last_ + distance) = CellState();
    }
  }
}

void LineSweep::mirrorCell(int ghost, int source)
{
  if (axis_ == 2)
  {
    cell(ghost) = Cell();
    state(ghost) = CellState();
    return;
  }
  Cell mirrored = cell(source);
  mirrored.velocity[axis_] = -mirrored.velocity[axis_];
  mirrored.deviator[symmetric[axis_][directions_[1]]] *= -1;
  mirrored.deviator[symmetric[axis_][directions_[2]]] *= -1;
  cell(ghost) = mirrored;
  state(ghost) = state(source);
}

double LineSweep::traction(int i, int q)
{
  return (q == 0 ? -state(i).pressure : 0) + cell(i).solid() * cell(i).deviator[symmetric[axis_][directions_[q]]];
}

LineSweep::FaceSide LineSweep::reconstruct(int face, int side)
{
  const int i = face - 1 + side;
  const double sign = side == 0 ? 1 : -1;
  // Linear where the cell and both its neighbours are full.
  const bool smooth = i > first_ - 2 && i < last_ + 2 && full(i - 1) && full(i) && full(i + 1);
  FaceSide result;
  for (int k = 0; k < 3; ++k)
  {
    const int d = directions_[k];
    const double speed = k == 0 ? state(i).longitudinalSpeed : state(i).shearSpeed;
    const double reach = 0.5 * std::max(0.0, 1 - speed * ratio_) * sign;
    const double velocity = cell(i).velocity[d];
    const double stress = traction(i, k);
    result.velocity[k] = velocity;
    result.traction[k] = stress;
    if (smooth)
    {
      result.velocity[k] +=
        reach * limitedSlope(velocity - cell(i - 1).velocity[d], cell(i + 1).velocity[d] - velocity);
      result.traction[k] += reach * limitedSlope(stress - traction(i - 1, k), traction(i + 1, k) - stress);
    }
  }
  return result;
}

void LineSweep::solveFace(int face)
{
  FaceSide side[2] = { reconstruct(face, 0), reconstruct(face, 1) };
  const double squeeze = std::max(0.0, side[0].velocity[0] - side[1].velocity[0]);
  for (int s = 0; s < 2; ++s)
  {
    const int i = face - 1 + s;
    const double mass = cell(i).totalMass();
    // Strong compression travels faster than sound: Us = c + s up.
    const double speed = state(i).longitudinalSpeed + 0.5 * state(i).hugoniotSlope * squeeze;
    side[s].impedance[0] = mass * speed;
    side[s].impedance[1] = mass * state(i).shearSpeed;
    fastest_ = mass > 0 ? std::max(fastest_, speed + std::fabs(cell(i).velocity[axis_])) : fastest_;
  }
  const bool closed = (face == first_ && first_ > 0) || (face == last_ + 1 && last_ < length_ - 1); // rest beyond
  for (int k = 0; k < 3; ++k)
  {
    const double left = side[0].impedance[k > 0];
    const double right = side[1].impedance[k > 0];
    const double sum = left + right;
    double& stress = faceTractions_[face][k];
    double& velocity = faceVelocities_[face][k];
    if (closed || sum <= 0) // no wave crosses; beside a mirror or the void nothing shears
    {
      stress = 0;
      velocity = closed || k == 0 ? 0 : cell(face - (cell(face).totalMass() == 0)).velocity[directions_[k]];
      continue;
    }
    const double* t[2] = { side[0].traction, side[1].traction };
    const double* v[2] = { side[0].velocity, side[1].velocity };
    stress = (right * t[0][k] + left * t[1][k] + left * right * (v[1][k] - v[0][k])) / sum;
    velocity = (left * v[0][k] + right * v[1][k] + t[1][k] - t[0][k]) / sum;
  }
  displacements_[face] = std::clamp(faceVelocities_[face][0] * ratio_, -0.49, 0.49);
  if (axis_ < 2 && face == 0)
  {
    displacements_[face] = 0;
  }
}

void LineSweep::moveCell(int i)
{
  Cell& c = cell(i);
  volumes_[i + 2] = 1 + displacements_[i + 1] - displacements_[i];
  const double mass = c.totalMass();
  if (mass <= 0)
  {
    return;
  }
  const auto &leftTraction = faceTractions_[i], &rightTraction = faceTractions_[i + 1];
  const auto &leftVelocity = faceVelocities_[i], &rightVelocity = faceVelocities_[i + 1];
  double heat = 0;
  for (int k = 0; k < 3; ++k)
  {
    double& velocity = c.velocity[directions_[k]];
    const double moved = velocity + ratio_ * (rightTraction[k] - leftTraction[k]) / mass;
    const double mean = 0.5 * (velocity + moved);
    heat += ratio_ * (rightTraction[k] * (rightVelocity[k] - mean) - leftTraction[k] * (leftVelocity[k] - mean));
    velocity = moved;
  }
  const double gap = 1 - c.solid();
  heat *= std::max(0.0, 1 - 10 * gap); // next to a free surface: adiabatic
  changeVolumes(i, heat, gap);
  deform(i, gap);
}

void LineSweep::changeVolumes(int i, double heat, double gap)
{
  Cell& c = cell(i);
  const double volume = volumes_[i + 2];
  const double weight[2] = { c.fraction[0] / state(i).bulkModulus[0], c.fraction[1] / state(i).bulkModulus[1] };
  const double sum = weight[0] + weight[1];
  const double change = gap > 0 ? std::min(0.0, gap + volume - 1) : volume - 1; // the void takes it first
  for (int k = 0; k < 2; ++k)
  {
    if (c.fraction[k] > 0)
    {
      c.fraction[k] = std::max(c.fraction[k] + change * weight[k] / sum, 0.2 * c.fraction[k]);
      c.energy[k] += heat * weight[k] / sum;
      c.energy[k] = std::max(c.energy[k], -0.002 * c.mass[k]);
    }
  }
}

/// The deviator: hypoelastic increment (from the derivative along the axis alone), Jaumann rotation, radial return.
void LineSweep::deform(int i, double gap)
{
  Cell& c = cell(i);
  const double shear = state(i).shearModulus;
  double gradient[3] = { 0, 0, 0 };
  for (int k = 0; k < 3; ++k)
  {
    gradient[directions_[k]] = ratio_ * (faceVelocities_[i + 1][k] - faceVelocities_[i][k]);
  }
  for (double& x : gradient)
  {
    x *= gap > 0 ? std::max(0.0, 1 - 5 * gap) : 1;
  }
  double stress[3][3], increment[3][3] = {}, spin[3][3] = {};
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      stress[p][q] = c.deviator[symmetric[p][q]];
    }
  }
  for (int p = 0; p < 3; ++p)
  {
    increment[p][p] -= 2.0 / 3 * shear * gradient[axis_];
    increment[p][axis_] += shear * gradient[p];
    increment[axis_][p] += shear * gradient[p];
    if (p != axis_)
    {
      spin[p][axis_] = 0.5 * gradient[p];
      spin[axis_][p] = -0.5 * gradient[p];
    }
  }
  double squared = 0;
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      for (int x = 0; x < 3; ++x)
      {
        increment[p][q] += spin[p][x] * stress[x][q] - stress[p][x] * spin[x][q];
      }
    }
  }
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      stress[p][q] += increment[p][q];
      squared += stress[p][q] * stress[p][q];
    }
  }
  const double vonMises = std::sqrt(1.5 * squared);
  const double scale = vonMises > state(i).yieldStrength ? state(i).yieldStrength / vonMises : 1;
  for (int p = 0; p < 3; ++p)
  {
    for (int q = p; q < 3; ++q)
    {
      c.deviator[symmetric[p][q]] = scale * stress[p][q];
    }
  }
}
}
