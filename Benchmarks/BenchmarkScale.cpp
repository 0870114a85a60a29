// Time and memory from small grids to large ones: BenchmarkScale EDGE prints a row of a Markdown table for EDGE^3
// cells. Each size runs in a process of its own, so that the largest memory is its own.

#include "Extract/Extract.h"
#include "Impact.h"
#include "Model/Progress.h"
#include "Native/ReadNativeData.h"
#include "Pipeline.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

using namespace strata;

namespace
{
const Vector ballCenter(0.52, 0.51, 0.49);
constexpr double ballRadius = 0.3;

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// An array of a function of the cells' centres.
template<typename Function>
ValueArray cellArray(int edge, const Function& function)
{
  const Index count = Index{ 1 } * edge * edge * edge;
  auto values = std::make_shared<std::vector<float>>(static_cast<std::size_t>(count));
  tbb::parallel_for(0, edge, [&](int k) {
    for (int j = 0; j < edge; ++j)
    {
      for (int i = 0; i < edge; ++i)
      {
        const Vector center = (Vector(i, j, k) + Vector::Constant(0.5)) / edge;
        (*values)[static_cast<std::size_t>((Index{ k } * edge + j) * edge + i)] = static_cast<float>(function(center));
      }
    }
  });
  return { values->data(), count, 1, values };
}

/// A ball in a unit cube, and a wavy field of both; 12 bytes a cell.
Simulation ballSimulation(int edge)
{
  RectilinearGrid grid;
  for (std::vector<double>& coordinates : grid.coordinates)
  {
    for (int i = 0; i <= edge; ++i)
    {
      coordinates.push_back(static_cast<double>(i) / edge);
    }
  }
  const auto fraction = [edge](const Vector& center) {
    const Vector outward = center - ballCenter;
    // The ball's surface is taken as a plane that turns slowly: linear between the cell's extreme corners.
    const double width = outward.cwiseAbs().sum() / outward.norm() / edge;
    return std::clamp(0.5 + (ballRadius - outward.norm()) / width, 0.0, 1.0);
  };
  const auto wave = [](const Vector& p) { return std::sin(5.0 * p[0]) * std::cos(4.0 * p[1]) + p[2]; };
  Simulation simulation;
  simulation.grid = std::move(grid);
  simulation.materials = { { "ball", true }, { "rest", true } };
  simulation.fractions = { cellArray(edge, fraction), cellArray(edge, [&](const Vector& center) {
                            return 1.0 - static_cast<double>(static_cast<float>(fraction(center)));
                          }) };
  const ValueArray waves = cellArray(edge, wave);
  simulation.fields = { { "wave", 1, Association::Cells, { waves, waves } } };
  return simulation;
}
}

int main(int argc, char** argv)
{
  const int edge = argc > 1 ? std::stoi(argv[1]) : 100;
  Progress progress;
  const Simulation simulation = ballSimulation(edge);
  const auto cells = static_cast<double>(cellCount(simulation.grid));
  const double inputMebibytes = benchmarks::peakMebibytes();
  auto start = std::chrono::steady_clock::now();
  Interfaces interfaces = extractInterfaces(simulation, {}, progress).interfaces;
  const double extraction = secondsSince(start);
  const double extractionMebibytes = benchmarks::peakMebibytes();
  start = std::chrono::steady_clock::now();
  Multiresolution multiresolution(readNativeData(simulation, {}, progress), std::move(interfaces), {});
  SelectOptions options;
  options.bounds = { 0.01, { 0.05 } };
  const Mesh mesh = multiresolution.level(options, progress);
  const double build = secondsSince(start);
  const double peak = benchmarks::peakMebibytes();
  std::cout << "| " << edge << " | " << cells << " | " << extraction << " | " << build << " | "
            << 1e9 * build / (cells * std::log2(cells)) << " | " << mesh.cellCount() << " | " << inputMebibytes << " | "
            << extractionMebibytes << " | " << peak << " | " << (peak - inputMebibytes) * 1048576.0 / cells << " |\n";
}
