#pragma once

#include "Build/CellElements.h"
#include "Model/Hierarchy.h"

namespace strata
{
/// The interface error of a cell over all of its interface triangles, clipped to it (design 2): the largest distance of
/// their points to the plane that stands for their interface.
///
/// A piece that the cell's representation leaves out altogether counts with its extent, if that is larger: a sheet or a
/// droplet of one material between vertices of another. So does one that lies on a junction's wrong side. It is
/// left out where no point of the cell has its two materials as the nearest ones. But where the plane merely passes
/// beside the cell, and the triangles face as it does, the neighbours represent it. No error is larger than the
/// cell. A cell without triangles is of one material: other materials represented in it count with their depth.
double certifiedInterfaceError(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const InterfaceElements& interfaces);
}
