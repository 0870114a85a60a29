#include "Native/ReadNativeData.h"

#include "Native/RectilinearData.h"
#include "Native/UnstructuredData.h"

#include <algorithm>

namespace strata
{
namespace
{
void checkArray(
  const ValueArray& values, const Grid& grid, Association association, int components, const std::string& what)
{
  const Index expected = association == Association::Cells ? cellCount(grid) : pointCount(grid);
  if (values && values.tuples() != expected)
  {
    throw InvalidInput(what + " has " + std::to_string(values.tuples()) + " values; the grid has " +
                       std::to_string(expected) + (association == Association::Cells ? " cells" : " points"));
  }
  if (values && values.components() != components)
  {
    throw InvalidInput(
      what + " has " + std::to_string(values.components()) + " components instead of " + std::to_string(components));
  }
}

void checkCount(std::size_t count, std::size_t expected, const std::string& what)
{
  if (count != expected)
  {
    throw InvalidInput(what + ": " + std::to_string(count) + " instead of " + std::to_string(expected));
  }
}

void checkMaterials(const Simulation& simulation)
{
  const std::size_t count = simulation.materials.size();
  if (count == 0 || count > static_cast<std::size_t>(MaterialSet::capacity))
  {
    throw InvalidInput("the data set has " + std::to_string(count) + " materials; 1 to " +
                       std::to_string(MaterialSet::capacity) + " are possible");
  }
  if (simulation.fractions.empty())
  {
    checkCount(
      simulation.materialIds.size(), static_cast<std::size_t>(cellCount(simulation.grid)), "material ids of the cells");
    return;
  }
  checkCount(simulation.fractions.size(), count, "arrays of volume fractions");
  for (std::size_t m = 0; m < count; ++m)
  {
    checkArray(simulation.fractions[m], simulation.grid, simulation.fractionAssociation, 1,
      "the volume fraction of material \"" + simulation.materials[m].name + "\"");
  }
}

void checkFields(const Simulation& simulation)
{
  for (const SimulationField& field : simulation.fields)
  {
    checkCount(field.values.size(), simulation.materials.size(), "arrays of field \"" + field.name + "\"");
    if (field.components < 1)
    {
      throw InvalidInput("field \"" + field.name + "\" has " + std::to_string(field.components) + " components");
    }
    for (std::size_t m = 0; m < field.values.size(); ++m)
    {
      checkArray(field.values[m], simulation.grid, field.association, field.components,
        "field \"" + field.name + "\" of material \"" + simulation.materials[m].name + "\"");
    }
  }
}

void checkGrid(const RectilinearGrid& grid)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& coordinates = grid.coordinates[axis];
    if (coordinates.size() < 2)
    {
      throw InvalidInput("the grid has " + std::to_string(coordinates.size()) + " points along axis " +
                         std::to_string(axis) + "; at least 2 are needed");
    }
    for (std::size_t i = 1; i < coordinates.size(); ++i)
    {
      if (!(coordinates[i] > coordinates[i - 1]))
      {
        throw InvalidInput("coordinate " + std::to_string(i) + " of axis " + std::to_string(axis) + " is " +
                           std::to_string(coordinates[i]) + " after " + std::to_string(coordinates[i - 1]));
      }
    }
  }
}

void checkGrid(const UnstructuredGrid& grid)
{
  if (grid.shapes.empty())
  {
    throw InvalidInput("the grid has no cells");
  }
  checkCount(grid.cornerOffsets.size(), grid.shapes.size() + 1, "offsets of the cells' corners");
  const auto wrong = std::find_if(
    grid.corners.begin(), grid.corners.end(), [&](Index point) { return point < 0 || point >= grid.pointCount(); });
  if (wrong != grid.corners.end())
  {
    throw InvalidInput("a cell has the corner " + std::to_string(*wrong) + "; the grid has " +
                       std::to_string(grid.pointCount()) + " points");
  }
}

/// Checks a grid's hidden cells too.
template<typename AnyGrid>
void checkSimulation(const AnyGrid& grid, const Simulation& simulation)
{
  checkGrid(grid);
  if (!grid.hidden.empty())
  {
    checkCount(grid.hidden.size(), static_cast<std::size_t>(grid.cellCount()), "marks of hidden cells");
  }
  checkMaterials(simulation);
  checkFields(simulation);
}
}

std::unique_ptr<NativeData> readNativeData(
  const Simulation& simulation, const NativeOptions& options, Progress& progress)
{
  std::visit([&](const auto& grid) { checkSimulation(grid, simulation); }, simulation.grid);
  if (std::holds_alternative<RectilinearGrid>(simulation.grid))
  {
    return std::make_unique<RectilinearData>(simulation, options, progress);
  }
  return std::make_unique<UnstructuredData>(simulation, options, progress);
}
}
