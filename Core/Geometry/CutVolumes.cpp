#include "Geometry/CutVolumes.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
using Coordinates = std::array<double, 4>;

int positionOf(const CornerValues* functions, int count, int function)
{
  return static_cast<int>(std::find_if(functions, functions + count, [function](const CornerValues& values) {
    return values.function == function;
  }) - functions);
}

/// Sums the determinants with `apex` of a fan over a face; each times the mean of a coordinate over its triangle,
/// if one is given.
double fan(const TetrahedronCut& cut, const TetrahedronCut::Face& face, const Coordinates& apex, int coordinate = -1)
{
  const int* loop = cut.loops().data();
  const std::vector<Coordinates>& at = cut.coordinates();
  double sum = 0.0;
  for (int i = face.begin + 1; i + 1 < face.end; ++i)
  {
    const Coordinates& a = at[loop[face.begin]];
    const Coordinates& b = at[loop[i]];
    const Coordinates& c = at[loop[i + 1]];
    const double weight = coordinate < 0 ? 1.0 : (a[coordinate] + b[coordinate] + c[coordinate]) / 3.0;
    sum += weight * volumeFraction(apex, a, b, c);
  }
  return cut.reversed() ? -sum : sum;
}

void addVolumes(const CornerValues* functions, int count, const TetrahedronCut& cut, double* volumes)
{
  std::fill(volumes, volumes + count, 0.0);
  int apex = -1;
  int function = -1;
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    if (face.function != function)
    {
      function = face.function;
      apex = cut.loops()[face.begin];
    }
    volumes[positionOf(functions, count, function)] += fan(cut, face, cut.coordinates()[apex]);
  }
}

/// A step in barycentric coordinates along which f_j - f_i grows by one.
Coordinates unitStep(const CornerValues& fi, const CornerValues& fj)
{
  Coordinates difference;
  for (int corner = 0; corner < 4; ++corner)
  {
    difference[corner] = fj.values[corner] - fi.values[corner];
  }
  const auto extremes = std::minmax_element(difference.begin(), difference.end());
  const double growth = *extremes.second - *extremes.first;
  Coordinates step{};
  step[extremes.second - difference.begin()] = 1.0 / growth;
  step[extremes.first - difference.begin()] = -1.0 / growth;
  return step;
}

/// The part near a lone corner with value v <= 0 among others a, b, c > 0.
NegativePart nearCorner(double v, double a, double b, double c)
{
  const double volume = v / (v - a) * (v / (v - b)) * (v / (v - c));
  return { volume, 3.0 * v / (v - a) * (v / (v - b)) / (c - v) };
}

/// The wedge between corners a, b <= 0 and c, d > 0: a prism cut into three tetrahedra.
NegativePart wedge(double a, double b, double c, double d)
{
  const double ac = a / (a - c);
  const double ad = a / (a - d);
  const double bc = b / (b - c);
  const double bd = b / (b - d);
  const double volume = ac * ad + (1.0 - ac) * ad * bc + (1.0 - ad) * bc * bd;
  const double area = ac * (1.0 - bd) + (1.0 - ac) * (1.0 - bd) * bc + ac * bd * (1.0 - bc);
  return { volume, 3.0 * area / (d - a) };
}

NegativePart firstOfTwo(const CornerValues* functions)
{
  std::array<double, 4> difference;
  for (int corner = 0; corner < 4; ++corner)
  {
    difference[corner] = functions[0].values[corner] - functions[1].values[corner];
  }
  return negativePart(difference);
}

/// For constants added at all corners, or at one alone: a point of an interface then moves as that corner's share in
/// it.
void addDerivatives(
  const CornerValues* functions, int count, const TetrahedronCut& cut, double* derivatives, int corner = -1)
{
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    if (!face.isInterface())
    {
      continue;
    }
    const int i = positionOf(functions, count, face.function);
    const int j = positionOf(functions, count, face.beyond);
    // The polygon sweeps prisms of three times the tetrahedron over each triangle and the step.
    const double swept = 3.0 * std::abs(fan(cut, face, unitStep(functions[i], functions[j]), corner));
    derivatives[count * i + j] += swept;
    derivatives[count * j + i] += swept;
    derivatives[count * i + i] -= swept;
    derivatives[count * j + j] -= swept;
  }
}
}

NegativePart negativePart(std::array<double, 4> g)
{
  std::sort(g.begin(), g.end());
  const auto negatives = std::upper_bound(g.begin(), g.end(), 0.0) - g.begin();
  switch (negatives)
  {
    case 0:
      return {};
    case 1:
      return nearCorner(g[0], g[1], g[2], g[3]);
    case 2:
      return wedge(g[0], g[1], g[2], g[3]);
    case 3: {
      const NegativePart rest = nearCorner(-g[3], -g[2], -g[1], -g[0]);
      return { 1.0 - rest.volume, rest.derivative };
    }
    default:
      return { 1.0, 0.0 };
  }
}

double volumeFraction(const std::array<double, 4>& a, const std::array<double, 4>& b, const std::array<double, 4>& c,
  const std::array<double, 4>& d)
{
  const double ab01 = a[0] * b[1] - a[1] * b[0];
  const double ab02 = a[0] * b[2] - a[2] * b[0];
  const double ab03 = a[0] * b[3] - a[3] * b[0];
  const double ab12 = a[1] * b[2] - a[2] * b[1];
  const double ab13 = a[1] * b[3] - a[3] * b[1];
  const double ab23 = a[2] * b[3] - a[3] * b[2];
  const double cd01 = c[0] * d[1] - c[1] * d[0];
  const double cd02 = c[0] * d[2] - c[2] * d[0];
  const double cd03 = c[0] * d[3] - c[3] * d[0];
  const double cd12 = c[1] * d[2] - c[2] * d[1];
  const double cd13 = c[1] * d[3] - c[3] * d[1];
  const double cd23 = c[2] * d[3] - c[3] * d[2];
  return ab01 * cd23 - ab02 * cd13 + ab03 * cd12 + ab12 * cd03 - ab13 * cd02 + ab23 * cd01;
}

void regionVolumes(const CornerValues* functions, int count, TetrahedronCut& workspace, double* volumes)
{
  if (count == 1)
  {
    volumes[0] = 1.0;
  }
  else if (count == 2)
  {
    volumes[0] = firstOfTwo(functions).volume;
    volumes[1] = 1.0 - volumes[0];
  }
  else
  {
    workspace.cut({ 0, 1, 2, 3 }, functions, count);
    addVolumes(functions, count, workspace, volumes);
  }
}

void regionVolumesAndDerivatives(
  const CornerValues* functions, int count, TetrahedronCut& workspace, double* volumes, double* derivatives)
{
  std::fill(derivatives, derivatives + count * count, 0.0);
  if (count == 2)
  {
    const NegativePart first = firstOfTwo(functions);
    volumes[0] = first.volume;
    volumes[1] = 1.0 - first.volume;
    derivatives[1] = derivatives[2] = first.derivative;
    derivatives[0] = derivatives[3] = -first.derivative;
    return;
  }
  regionVolumes(functions, count, workspace, volumes);
  if (count > 2)
  {
    addDerivatives(functions, count, workspace, derivatives);
  }
}

void regionVolumesAndCornerDerivatives(
  const CornerValues* functions, int count, TetrahedronCut& workspace, double* volumes, double* derivatives)
{
  std::fill(derivatives, derivatives + count * count, 0.0);
  workspace.cut({ 0, 1, 2, 3 }, functions, count);
  addVolumes(functions, count, workspace, volumes);
  addDerivatives(functions, count, workspace, derivatives, 0);
}
}
