#include "Conversion/InputMaterials.h"

#include "Conversion/BlockNames.h"
#include "Conversion/CheckFractions.h"
#include "Conversion/InputArrays.h"
#include "Conversion/MaterialNames.h"
#include "Conversion/ValueConversion.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace strata::conversion
{
namespace
{
/// Ids up to here are all materials, present or not, up to the highest: so that a material's place stays the same over
/// time where another one vanishes.
constexpr std::int64_t largestListedId = 16;

struct FractionArray
{
  std::string material;
  std::string array;
};

struct FractionArrays
{
  Association association = Association::Cells;
  std::vector<FractionArray> arrays;
};

std::vector<std::string> namesOf(const std::vector<ArrayInfo>& arrays)
{
  std::vector<std::string> result;
  for (const ArrayInfo& array : arrays)
  {
    result.push_back(array.name);
  }
  return result;
}

/// Where the named arrays live: all in cells, or all in points. Throws InvalidInput that names one that is missing.
Association associationOf(const InputGrid& input, const std::vector<FractionArray>& named)
{
  const auto cells = arraysOf(input, Association::Cells);
  const auto points = arraysOf(input, Association::Points);
  const auto allIn = [&](const std::vector<ArrayInfo>& arrays) {
    return std::all_of(named.begin(), named.end(), [&](const FractionArray& f) { return find(arrays, f.array); });
  };
  if (allIn(cells))
  {
    return Association::Cells;
  }
  if (allIn(points))
  {
    return Association::Points;
  }
  for (const FractionArray& f : named)
  {
    if (!find(cells, f.array) && !find(points, f.array))
    {
      throw InvalidInput("The volume fraction array '" + f.array + "' of material '" + f.material +
                         "' is missing. Cell arrays: " + listed(namesOf(cells)) +
                         "; point arrays: " + listed(namesOf(points)));
    }
  }
  throw InvalidInput("Volume fractions must be all in cells or all at points");
}

FractionArrays recognized(const InputGrid& input)
{
  FractionArrays result;
  for (const Association association : { Association::Cells, Association::Points })
  {
    for (const ArrayInfo& array : arraysOf(input, association))
    {
      const auto material = materialOfFractions(array.name);
      if (material && array.components == 1 && (array.floating || array.bytes))
      {
        result.association = association;
        result.arrays.push_back({ *material, array.name });
      }
    }
    if (!result.arrays.empty())
    {
      break;
    }
  }
  return result;
}

FractionArrays chosen(const InputGrid& input, const SimulationOptions& options)
{
  FractionArrays result;
  for (const std::string& name : options.volumeFractionArrays)
  {
    result.arrays.push_back({ materialOfFractions(name).value_or(name), name });
  }
  result.association = associationOf(input, result.arrays);
  return result;
}

ValueArray fractionValues(const InputGrid& input, Association association, const std::string& name)
{
  ValueArray array = values(input, association, name);
  if (array.components() != 1)
  {
    throw InvalidInput("The volume fraction array '" + name + "' has " + std::to_string(array.components()) +
                       " components; one is needed");
  }
  const auto infos = arraysOf(input, association);
  if (!find(infos, name)->bytes)
  {
    return array;
  }
  // ParaView's CTH reader gives fractions as bytes by default, 255 standing for 1.
  std::vector<float> scaled(static_cast<std::size_t>(array.tuples()));
  for (std::size_t i = 0; i < scaled.size(); ++i)
  {
    scaled[i] = static_cast<float>(array(static_cast<Index>(i)) / 255.0);
  }
  return ownedValues(std::move(scaled));
}

const std::vector<std::uint8_t>& hiddenOf(const InputGrid& input)
{
  static const std::vector<std::uint8_t> none;
  const auto* rectilinear = std::get_if<RectilinearGrid>(&input.grid);
  return rectilinear ? rectilinear->hidden : none;
}

std::vector<std::string> namesOf(const Materials& materials)
{
  std::vector<std::string> result;
  for (const Material& material : materials)
  {
    result.push_back(material.name);
  }
  return result;
}

void checkDistinct(const Materials& materials)
{
  std::set<std::string> seen;
  for (const Material& material : materials)
  {
    if (!seen.insert(material.name).second)
    {
      throw InvalidInput("Two volume fraction arrays stand for the same material '" + material.name + "'");
    }
  }
}

/// Fractions of all materials; the remainder's, if it is one of them, is filled in.
void readFractions(const InputGrid& input, const FractionArrays& arrays, const SimulationOptions& options,
  Simulation& simulation, Warnings& warnings)
{
  simulation.fractionAssociation = arrays.association;
  const FractionPlaces places{ input, arrays.association, hiddenOf(input) };
  std::vector<ValueArray> named;
  for (const FractionArray& fraction : arrays.arrays)
  {
    if (!fraction.array.empty())
    {
      named.push_back(fractionValues(input, arrays.association, fraction.array));
    }
  }
  std::size_t next = 0;
  for (const FractionArray& fraction : arrays.arrays)
  {
    simulation.materials.push_back({ fraction.material, true });
    simulation.fractions.push_back(fraction.array.empty() ? remainderOf(named) : named[next++]);
  }
  checkDistinct(simulation.materials);
  const bool complete = named.size() < arrays.arrays.size();
  if (!complete && (named.size() == 1 || leaveSpace(named, places)))
  {
    const std::string name = options.remainderMaterial.empty() ? "empty" : options.remainderMaterial;
    const auto taken = namesOf(simulation.materials);
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
    {
      throw InvalidInput("The volume fractions leave space, but the remainder's name '" + name +
                         "' is that of another material: choose another RemainderMaterial");
    }
    simulation.materials.push_back({ name, true });
    simulation.fractions.push_back(remainderOf(named));
  }
  normaliseFractions(simulation.fractions, namesOf(simulation.materials), places, warnings);
}

void readIds(const InputGrid& input, const std::string& name, Simulation& simulation)
{
  const auto arrays = arraysOf(input, Association::Cells);
  if (!find(arrays, name))
  {
    throw InvalidInput(
      "The cell array '" + name + "' of material ids is missing. Cell arrays: " + listed(namesOf(arrays)));
  }
  const std::vector<std::int64_t> ids = integers(input, name);
  const auto& hidden = hiddenOf(input);
  std::map<std::int64_t, std::int32_t> places;
  for (std::size_t cell = 0; cell < ids.size(); ++cell)
  {
    if (!hidden.empty() && hidden[cell])
    {
      continue;
    }
    if (ids[cell] < 0)
    {
      throw InvalidInput("The material id of " + describeCell(input, static_cast<Index>(cell)) + " is " +
                         integerAt(input, name, static_cast<Index>(cell)) + "; ids must be from 0 to " +
                         std::to_string(std::numeric_limits<std::int64_t>::max()));
    }
    places.emplace(ids[cell], 0);
    if (places.size() > static_cast<std::size_t>(MaterialSet::capacity))
    {
      break;
    }
  }
  const std::int64_t highest = places.empty() ? 0 : places.rbegin()->first;
  for (std::int64_t id = 1; id < highest && highest <= largestListedId; ++id)
  {
    places.emplace(id, 0);
  }
  for (auto& [id, place] : places)
  {
    place = static_cast<std::int32_t>(simulation.materials.size());
    simulation.materials.push_back({ "Material " + std::to_string(id), true });
  }
  simulation.materialIds.resize(ids.size());
  for (std::size_t cell = 0; cell < ids.size(); ++cell)
  {
    const auto at = places.find(ids[cell]);
    simulation.materialIds[cell] = at == places.end() ? 0 : at->second;
  }
  if (isBlockIdName(name))
  {
    nameAfterBlocks(input, simulation);
  }
}

/// For data that say nothing of materials.
void useOneMaterial(const InputGrid& input, Simulation& simulation, Warnings& warnings)
{
  for (const ArrayInfo& array : arraysOf(input, Association::Cells))
  {
    if (isMaterialIdName(array.name))
    {
      warnings.push_back("The cell array '" + array.name + "' can't hold material ids, for which there must be one " +
                         "integer per cell: all cells are taken as one material");
    }
  }
  simulation.materials = { { "material", true } };
  simulation.materialIds.assign(static_cast<std::size_t>(cellCount(input.grid)), 0);
}

/// Hidden cells, and space that no cell fills, belong to a material of its own.
void addOutside(const InputGrid& input, Simulation& simulation)
{
  const auto taken = namesOf(simulation.materials);
  if (!input.hasOutside || std::find(taken.begin(), taken.end(), "outside") != taken.end())
  {
    return;
  }
  const auto outside = static_cast<std::int32_t>(simulation.materials.size());
  simulation.materials.push_back({ "outside", false });
  const auto& hidden = hiddenOf(input);
  for (std::size_t cell = 0; cell < hidden.size() && !simulation.materialIds.empty(); ++cell)
  {
    simulation.materialIds[cell] = hidden[cell] ? outside : simulation.materialIds[cell];
  }
  if (!simulation.fractions.empty())
  {
    std::vector<float> fraction(static_cast<std::size_t>(simulation.fractions.front().tuples()), 0.0f);
    for (std::size_t cell = 0; cell < hidden.size() && simulation.fractionAssociation == Association::Cells; ++cell)
    {
      fraction[cell] = hidden[cell] ? 1.0f : 0.0f;
    }
    simulation.fractions.push_back(ownedValues(std::move(fraction)));
  }
}

/// "None" is how ParaView's panel says that no array is chosen.
bool namesIds(const SimulationOptions& options)
{
  return !options.materialIdArray.empty() && options.materialIdArray != "None";
}

std::string idArray(const InputGrid& input, const SimulationOptions& options)
{
  if (namesIds(options))
  {
    return options.materialIdArray;
  }
  for (const ArrayInfo& array : arraysOf(input, Association::Cells))
  {
    if (isMaterialIdName(array.name) && !array.floating && array.components == 1)
    {
      return array.name;
    }
  }
  return "";
}

FractionArrays ofCase(const InputGrid& input, const CaseDescription& description)
{
  FractionArrays result;
  std::vector<FractionArray> present;
  for (std::size_t m = 0; m < description.materials.size(); ++m)
  {
    result.arrays.push_back({ description.materials[m].name, description.fractionArrays[m] });
    if (!description.fractionArrays[m].empty())
    {
      present.push_back(result.arrays.back());
    }
  }
  result.association = associationOf(input, present);
  return result;
}
}

MaterialRoles readMaterials(const InputGrid& input, const CaseDescription& description,
  const SimulationOptions& options, Simulation& simulation, Warnings& warnings)
{
  const bool userSays = !options.volumeFractionArrays.empty() || namesIds(options) || options.blocksAsMaterials;
  FractionArrays arrays;
  if (!options.volumeFractionArrays.empty())
  {
    arrays = chosen(input, options);
  }
  else if (!userSays)
  {
    arrays = description.materials.empty() ? recognized(input) : ofCase(input, description);
  }
  MaterialRoles roles;
  const std::string ids = idArray(input, options);
  if (!arrays.arrays.empty())
  {
    readFractions(input, arrays, options, simulation, warnings);
  }
  else if (options.blocksAsMaterials)
  {
    readBlocks(input, simulation);
  }
  else if (!ids.empty())
  {
    readIds(input, ids, simulation);
  }
  else
  {
    useOneMaterial(input, simulation, warnings);
  }
  addOutside(input, simulation);
  if (simulation.materials.size() > static_cast<std::size_t>(MaterialSet::capacity))
  {
    throw InvalidInput("There are more than " + std::to_string(MaterialSet::capacity) + " materials");
  }
  for (const FractionArray& fraction : arrays.arrays)
  {
    roles.arrays.push_back(fraction.array);
  }
  roles.arrays.push_back(ids);
  return roles;
}
}
