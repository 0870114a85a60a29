#include "Native/SampleMaterials.h"

#include "Model/Errors.h"
#include "Native/Topology.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace strata
{
namespace
{
/// Samples that one task works on. A chunk's own table of sets can't have more entries than that.
constexpr Index chunkSize = 65536;
constexpr std::size_t tableCapacity = 65536;

/// Finds the set of one sample.
class MaterialRule
{
public:
  MaterialRule(const Simulation& simulation, Association association, double minimumVolumeFraction) :
    simulation_(simulation), association_(association), minimum_(minimumVolumeFraction),
    given_(simulation.fractions.empty() ? Association::Cells : simulation.fractionAssociation),
    topology_(simulation.grid, association == Association::Points)
  {}

  /// `sources` is working memory.
  MaterialSet operator()(Index sample, std::vector<Index>& sources) const
  {
    if (!findSources(sample, sources))
    {
      return {};
    }
    return simulation_.fractions.empty() ? fromIds(sources) : fromFractions(sources);
  }

private:
  /// The cells or points whose fractions or ids tell those of the sample; false where it is hidden.
  bool findSources(Index sample, std::vector<Index>& sources) const
  {
    if (association_ == Association::Cells)
    {
      if (topology_.hidden(sample))
      {
        return false;
      }
      if (given_ == Association::Points)
      {
        topology_.corners(sample, sources);
        return true;
      }
    }
    else
    {
      topology_.visibleCells(sample, sources);
      if (given_ == Association::Cells || sources.empty())
      {
        return !sources.empty();
      }
    }
    sources.assign(1, sample);
    return true;
  }

  MaterialSet fromIds(const std::vector<Index>& cells) const
  {
    MaterialSet result;
    for (const Index cell : cells)
    {
      const std::int32_t id = simulation_.materialIds[static_cast<std::size_t>(cell)];
      if (id < 0 || static_cast<std::size_t>(id) >= simulation_.materials.size())
      {
        throw InvalidInput("material id " + std::to_string(id) + " of cell " + std::to_string(cell) + ": there are " +
                           std::to_string(simulation_.materials.size()) + " materials");
      }
      if (simulation_.materials[static_cast<std::size_t>(id)].hasFields)
      {
        result.insert(MaterialId(id));
      }
    }
    return result;
  }

  MaterialSet fromFractions(const std::vector<Index>& sources) const
  {
    MaterialSet result;
    double largest = 0.0;
    MaterialId dominant;
    for (std::size_t m = 0; m < simulation_.materials.size(); ++m)
    {
      const double fraction = meanFraction(simulation_.fractions[m], sources);
      if (fraction > largest)
      {
        largest = fraction;
        dominant = MaterialId(static_cast<Index>(m));
      }
      if (fraction > 0.0 && fraction >= minimum_ && simulation_.materials[m].hasFields)
      {
        result.insert(MaterialId(static_cast<Index>(m)));
      }
    }
    if (dominant.valid() && simulation_.materials[static_cast<std::size_t>(dominant.value)].hasFields)
    {
      result.insert(dominant);
    }
    return result;
  }

  static double meanFraction(const ValueArray& fractions, const std::vector<Index>& sources)
  {
    if (!fractions)
    {
      return 0.0;
    }
    double sum = 0.0;
    for (const Index source : sources)
    {
      sum += fractions(source);
    }
    return sum / static_cast<double>(sources.size());
  }

  const Simulation& simulation_;
  Association association_;
  double minimum_;
  Association given_;
  Topology topology_;
};

/// Position of a set in a table; it is appended where it is new. The last one found comes first in the
/// search, since neighbours are mostly alike.
std::size_t positionIn(std::vector<MaterialSet>& table, MaterialSet set, std::size_t last)
{
  if (last < table.size() && table[last] == set)
  {
    return last;
  }
  const auto found = std::find(table.begin(), table.end(), set);
  const auto position = static_cast<std::size_t>(found - table.begin());
  if (found == table.end())
  {
    table.push_back(set);
  }
  return position;
}
}

SampleMaterials findSampleMaterials(
  const Simulation& simulation, Association association, double minimumVolumeFraction, Progress& progress)
{
  const Index count = association == Association::Cells ? cellCount(simulation.grid) : pointCount(simulation.grid);
  const MaterialRule rule(simulation, association, minimumVolumeFraction);
  const Index chunkCount = (count + chunkSize - 1) / chunkSize;
  std::vector<std::vector<MaterialSet>> chunkTables(static_cast<std::size_t>(chunkCount));
  SampleMaterials result;
  result.indices_ = Buffer<std::uint16_t>(count);

  tbb::parallel_for(Index{ 0 }, chunkCount, [&](Index chunk) {
    progress.check();
    std::vector<MaterialSet>& table = chunkTables[static_cast<std::size_t>(chunk)];
    std::vector<Index> sources;
    std::size_t last = 0;
    const Index end = std::min(count, (chunk + 1) * chunkSize);
    for (Index sample = chunk * chunkSize; sample < end; ++sample)
    {
      last = positionIn(table, rule(sample, sources), last);
      result.indices_[sample] = static_cast<std::uint16_t>(last);
    }
  });

  std::vector<std::vector<std::uint16_t>> positions(chunkTables.size());
  for (std::size_t chunk = 0; chunk < chunkTables.size(); ++chunk)
  {
    for (const MaterialSet set : chunkTables[chunk])
    {
      positions[chunk].push_back(static_cast<std::uint16_t>(positionIn(result.table_, set, 0)));
      result.present_ = result.present_ | set;
    }
  }
  if (result.table_.size() > tableCapacity)
  {
    throw InvalidInput("the samples have " + std::to_string(result.table_.size()) +
                       " different sets of materials; at most " + std::to_string(tableCapacity) + " are possible");
  }
  tbb::parallel_for(Index{ 0 }, chunkCount, [&](Index chunk) {
    progress.check();
    const std::vector<std::uint16_t>& position = positions[static_cast<std::size_t>(chunk)];
    const Index end = std::min(count, (chunk + 1) * chunkSize);
    for (Index sample = chunk * chunkSize; sample < end; ++sample)
    {
      result.indices_[sample] = position[result.indices_[sample]];
    }
  });
  return result;
}
}
