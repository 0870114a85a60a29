#pragma once

#include "Conversion/InputGrid.h"

#include "Model/Simulation.h"

#include <string>
#include <unordered_map>

class vtkDataObject;

namespace strata::conversion
{
/// The names of a collection's data sets: a data set's own, else that of the innermost named collection it is in.
/// Those without any name are left out.
std::unordered_map<const vtkDataObject*, std::string> blockNames(vtkDataObject* data);

/// Whether an array of that name numbers the blocks that cells belong to, as the readers of Exodus files write it.
bool isBlockIdName(const std::string& array);

/// Each block becomes a material, those of the same name together.
void readBlocks(const InputGrid& input, Simulation& simulation);

/// Names the materials of a simulation with ids after blocks, if each of them that occurs is one block's.
void nameAfterBlocks(const InputGrid& input, Simulation& simulation);
}
