#include "Conversion/BlockNames.h"

#include "Conversion/InputArrays.h"

#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>
#include <array>
#include <set>

namespace strata::conversion
{
namespace
{
using Names = std::unordered_map<const vtkDataObject*, std::string>;

template<typename Collection>
std::string nameOf(Collection* collection, unsigned int child, const std::string& inherited)
{
  const char* own =
    collection->HasMetaData(child) ? collection->GetMetaData(child)->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return own && *own ? own : inherited;
}

void collect(vtkDataObject* data, const std::string& name, Names& names)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      collect(blocks->GetBlock(i), nameOf(blocks, i, name), names);
    }
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < parts->GetNumberOfPartitions(); ++i)
    {
      collect(parts->GetPartitionAsDataObject(i), nameOf(parts, i, name), names);
    }
  }
  else if (auto* sets = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < sets->GetNumberOfPartitionedDataSets(); ++i)
    {
      collect(sets->GetPartitionedDataSet(i), nameOf(sets, i, name), names);
    }
  }
  else if (data && !name.empty())
  {
    names.emplace(data, name);
  }
}
}

Names blockNames(vtkDataObject* data)
{
  Names names;
  collect(data, "", names);
  return names;
}

bool isBlockIdName(const std::string& array)
{
  const std::array<const char*, 4> known = { "ObjectId", "ElementBlockIds", "BlockId", "vtkCompositeIndex" };
  return std::find(known.begin(), known.end(), array) != known.end();
}

void readBlocks(const InputGrid& input, Simulation& simulation)
{
  std::unordered_map<std::string, std::int32_t> places;
  std::vector<std::int32_t> ofBlock;
  for (const InputBlock& block : input.blocks)
  {
    const std::string name = block.label.empty() ? "Block " + std::to_string(ofBlock.size() + 1) : block.label;
    const auto [place, isNew] = places.emplace(name, static_cast<std::int32_t>(simulation.materials.size()));
    if (isNew)
    {
      simulation.materials.push_back({ name, true });
    }
    ofBlock.push_back(place->second);
  }
  for (const std::size_t block : blocksOfCells(input))
  {
    simulation.materialIds.push_back(ofBlock[block]);
  }
}

void nameAfterBlocks(const InputGrid& input, Simulation& simulation)
{
  std::vector<std::set<std::string>> found(simulation.materials.size());
  const std::vector<std::size_t> blocks = blocksOfCells(input);
  for (std::size_t cell = 0; cell < blocks.size(); ++cell)
  {
    const auto material = static_cast<std::size_t>(simulation.materialIds[cell]);
    if (cell == 0 || blocks[cell] != blocks[cell - 1] ||
        simulation.materialIds[cell] != simulation.materialIds[cell - 1])
    {
      found[material].insert(input.blocks[blocks[cell]].label);
    }
  }
  std::set<std::string> names;
  for (const std::set<std::string>& ofMaterial : found)
  {
    const bool one = ofMaterial.size() == 1 && !ofMaterial.begin()->empty();
    if (!ofMaterial.empty() && (!one || !names.insert(*ofMaterial.begin()).second))
    {
      return;
    }
  }
  for (std::size_t m = 0; m < found.size(); ++m)
  {
    simulation.materials[m].name = found[m].empty() ? simulation.materials[m].name : *found[m].begin();
  }
}
}
