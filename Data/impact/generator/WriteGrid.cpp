#include "Simulation.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace impact
{
namespace
{
/// The arrays of a file, one tuple per output cell.
struct Arrays
{
  explicit Arrays(std::size_t cells) : velocity(3 * cells)
  {
    for (auto& array : scalars)
    {
      array.resize(cells);
    }
  }

  static constexpr const char* names[7] = { "density", "pressure", "volume_fraction_projectile",
    "volume_fraction_block", "volume_fraction_empty", "density_projectile", "density_block" };
  std::vector<float> scalars[7];
  std::vector<float> velocity;
};

/// Averages over the simulation's cells in one output cell.
struct Average
{
  double fraction[2] = { 0, 0 }, mass[2] = { 0, 0 }, momentum[3] = { 0, 0, 0 }, pressure = 0;
};

/// Rounded to a multiple of 1 / perUnit, so that the files compress well; never -0.
float rounded(double x, double perUnit)
{
  return float(std::round(x * perUnit) / perUnit + 0.0);
}

Average average(const Simulation& simulation, const int corner[3], int size)
{
  Average result;
  const double weight = 1.0 / (double(size) * size * size);
  for (int w = 0; w < size * size * size; ++w)
  {
    Cell cell =
      simulation
        .cells[simulation.cellAt(corner[0] + w % size, corner[1] + w / size % size, corner[2] + w / (size * size))];
    const double pressure = relax(cell, simulation.metals).pressure;
    for (int k = 0; k < 2; ++k)
    {
      result.fraction[k] += weight * cell.fraction[k];
      result.mass[k] += weight * cell.mass[k];
    }
    for (int k = 0; k < 3; ++k)
    {
      result.momentum[k] += weight * cell.totalMass() * cell.velocity[k];
    }
    result.pressure += weight * pressure;
  }
  return result;
}

/// Volume fractions as multiples of 2^-20, whose sum is exactly 1 in single precision too.
void roundFractions(const Average& average, double fraction[2])
{
  const double unit = 1 << 20;
  for (int k = 0; k < 2; ++k)
  {
    const bool isDust = average.fraction[k] < 1e-4;
    fraction[k] = isDust ? 0 : std::round(average.fraction[k] * unit) / unit;
  }
  if (fraction[0] + fraction[1] > 1 - 1e-4) // nor are pores shown
  {
    const int larger = fraction[0] >= fraction[1] ? 0 : 1;
    fraction[larger] = 1 - fraction[1 - larger];
  }
}

void store(const Average& average, std::size_t id, Arrays& arrays)
{
  double fraction[2], density[2];
  roundFractions(average, fraction);
  double mean = 0;
  for (int k = 0; k < 2; ++k)
  {
    density[k] = fraction[k] > 0 ? rounded(average.mass[k] / average.fraction[k], 2e3) : 0;
    mean += fraction[k] * density[k];
  }
  const double values[7] = { mean, mean > 0 ? rounded(average.pressure, 1e5) : 0, fraction[0], fraction[1],
    1 - fraction[0] - fraction[1], density[0], density[1] };
  for (int a = 0; a < 7; ++a)
  {
    arrays.scalars[a][id] = float(values[a]);
  }
  const double mass = average.mass[0] + average.mass[1];
  for (int k = 0; k < 3; ++k)
  {
    arrays.velocity[3 * id + k] = mean > 0 && mass > 0 ? rounded(average.momentum[k] / mass, 2e4) : 0;
  }
}

std::string base64(const std::vector<unsigned char>& bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const bool second = i + 1 < bytes.size();
    const bool third = i + 2 < bytes.size();
    const unsigned x = bytes[i] << 16 | (second ? bytes[i + 1] << 8 : 0) | (third ? bytes[i + 2] : 0);
    text += digits[x >> 18];
    text += digits[x >> 12 & 63];
    text += second ? digits[x >> 6 & 63] : '=';
    text += third ? digits[x & 63] : '=';
  }
  return text;
}

template<typename T>
void writeArray(std::ostream& file, const char* name, int components, const std::vector<T>& values)
{
  const std::uint64_t size = sizeof(T) * values.size();
  std::vector<unsigned char> bytes(sizeof size + size);
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, values.data(), size);
  file << "<DataArray type=\"" << (sizeof(T) == 4 ? "Float32" : "Float64") << "\" Name=\"" << name
       << "\" NumberOfComponents=\"" << components << "\" format=\"binary\">\n"
       << base64(bytes) << "\n</DataArray>\n";
}

void writeFile(std::ostream& file, const Arrays& arrays, const int count[3], double time)
{
  std::ostringstream extent;
  extent << "Extent=\"0 " << count[0] << " 0 " << count[1] << " 0 " << count[2] << "\">\n";
  file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"RectilinearGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
       << "header_type=\"UInt64\">\n<RectilinearGrid Whole" << extent.str() << "<FieldData>\n"
       << "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" << time
       << "</DataArray>\n</FieldData>\n<Piece " << extent.str() << "<PointData/>\n"
       << "<CellData Scalars=\"density\" Vectors=\"velocity\">\n";
  for (int a = 0; a < 7; ++a)
  {
    writeArray(file, Arrays::names[a], 1, arrays.scalars[a]);
  }
  writeArray(file, "velocity", 3, arrays.velocity);
  file << "</CellData>\n<Coordinates>\n";
  for (int d = 0; d < 3; ++d)
  {
    std::vector<double> coordinates;
    for (int i = 0; i <= count[d]; ++i)
    {
      coordinates.push_back(lowerCorner[d] + (upperCorner[d] - lowerCorner[d]) * i / count[d]);
    }
    writeArray(file, d == 0 ? "x" : d == 1 ? "y" : "z", 1, coordinates);
  }
  file << "</Coordinates>\n</Piece>\n</RectilinearGrid>\n</VTKFile>\n";
}
}

void writeGrid(const Simulation& simulation, int factor, int index, double time)
{
  const int size = simulation.options.res / factor;
  int count[3];
  for (int d = 0; d < 3; ++d)
  {
    count[d] = coarseCells[d] * factor;
  }
  const std::size_t cells = std::size_t(count[0]) * count[1] * count[2];
  Arrays arrays(cells);
#pragma omp parallel for
  for (int k = 0; k < count[2]; ++k)
  {
    for (int row = 0; row < count[0] * count[1]; ++row)
    {
      const int corner[3] = { row % count[0] * size, row / count[0] * size, k * size };
      store(average(simulation, corner, size), row + std::size_t(count[0]) * count[1] * k, arrays);
    }
  }
  char name[64];
  std::snprintf(name, sizeof name, "/impact_%d_%02d.vtr", coarseCells[0] * factor, index);
  std::ofstream file(simulation.options.dir + name, std::ios::binary);
  writeFile(file, arrays, count, time);
  if (!file)
  {
    throw std::runtime_error("cannot write " + simulation.options.dir + name);
  }
}
}
