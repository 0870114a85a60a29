#pragma once

#include "vtkStrataMaterialsFilter.h"

#include <string>
#include <vector>

struct vtkStrataMaterialsFilter::Lists
{
  std::vector<std::string> materials;
};
