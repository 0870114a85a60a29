#pragma once

#include "Extract/MixedRegion.h"

namespace strata
{
/// Replaces volume fractions by signed distances to the border of each material, positive inside it, in the data's
/// length unit; a flat border is represented exactly.
///
/// In each cell that a material fills in part, a plane bounds its fraction; at points and face centres the planes of
/// the cells around are averaged. The planes' normals come from the fractions in the cells around at first, then,
/// in a few sweeps, from the distances at the cell's points. Where the fractions around have no common direction
/// (a sheet thinner than a cell, a droplet) a value near zero lets the other materials decide.
void turnIntoDistances(const MixedRegion& region, MaterialValues& values, Progress& progress);
}
