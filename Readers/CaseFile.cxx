#include "CaseFile.h"

#include "JsonValue.h"

#include "Conversion/ValueConversion.h"

#include "Model/Errors.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <set>

namespace
{
constexpr int supportedVersion = 1;

using strata::InvalidInput;

strata::Materials readMaterials(const JsonValue& list)
{
  strata::Materials materials;
  std::set<std::string> seen;
  for (const JsonValue& entry : list.elements())
  {
    strata::Material material;
    if (entry.isText())
    {
      material.name = entry.text();
    }
    else
    {
      entry.expectKeys({ "name", "fields" });
      material.name = entry.at("name").text();
      material.hasFields = !entry.has("fields") || entry.at("fields").boolean();
    }
    if (material.name.empty() || !seen.insert(material.name).second)
    {
      throw InvalidInput(entry.where() + ": the material '" + material.name + "' is empty or named twice");
    }
    materials.push_back(material);
  }
  if (materials.empty())
  {
    throw InvalidInput(list.where() + ": there are no materials");
  }
  return materials;
}

void expectMaterial(const std::string& name, const strata::Materials& materials, const std::string& where)
{
  std::vector<std::string> known;
  std::transform(materials.begin(), materials.end(), std::back_inserter(known),
    [](const strata::Material& material) { return material.name; });
  if (std::find(known.begin(), known.end(), name) == known.end())
  {
    throw InvalidInput(
      where + ": there is no material '" + name + "'; materials: " + strata::conversion::listed(known));
  }
}

std::vector<std::string> readFractions(const JsonValue& arrays, const strata::Materials& materials)
{
  for (const std::string& name : arrays.keys())
  {
    expectMaterial(name, materials, arrays.where());
  }
  std::vector<std::string> result;
  int missing = 0;
  for (const strata::Material& material : materials)
  {
    result.push_back(arrays.has(material.name) ? arrays.at(material.name).text() : "");
    missing += result.back().empty();
    if (missing > 1)
    {
      throw InvalidInput(arrays.where() + ": the material '" + material.name +
                         "' has no array; only one material may be what the others leave");
    }
  }
  return result;
}

std::vector<strata::conversion::CaseField> readFields(const JsonValue& fields, const strata::Materials& materials)
{
  std::vector<strata::conversion::CaseField> result;
  for (const std::string& field : fields.keys())
  {
    const JsonValue value = fields.at(field);
    if (value.isText())
    {
      result.push_back({ field, "", value.text() });
      continue;
    }
    for (const std::string& material : value.keys())
    {
      expectMaterial(material, materials, value.where());
      result.push_back({ field, material, value.at(material).text() });
    }
  }
  return result;
}

std::string resolved(const std::string& path, const std::string& folder)
{
  return vtksys::SystemTools::FileIsFullPath(path) || folder.empty() ? path : folder + "/" + path;
}

CaseFile::Step readStep(const JsonValue& entry, const strata::Materials& materials, const std::string& folder)
{
  entry.expectKeys({ "time", "grid", "interfaces" });
  CaseFile::Step step;
  step.time = entry.has("time") ? entry.at("time").number() : 0.0;
  step.grid = resolved(entry.at("grid").text(), folder);
  step.hasInterfaces = entry.has("interfaces");
  if (!step.hasInterfaces)
  {
    return step;
  }
  for (const JsonValue& surface : entry.at("interfaces").elements())
  {
    surface.expectKeys({ "surface", "positive", "negative" });
    step.interfaces.push_back(
      { resolved(surface.at("surface").text(), folder), surface.at("positive").text(), surface.at("negative").text() });
    expectMaterial(step.interfaces.back().positive, materials, surface.where());
    expectMaterial(step.interfaces.back().negative, materials, surface.where());
  }
  return step;
}

std::vector<CaseFile::Step> readSteps(
  const JsonValue& list, const strata::Materials& materials, const std::string& folder)
{
  std::vector<CaseFile::Step> steps;
  for (const JsonValue& entry : list.elements())
  {
    steps.push_back(readStep(entry, materials, folder));
    if (steps.size() > 1 && !(steps.back().time > steps[steps.size() - 2].time))
    {
      throw InvalidInput(entry.where() + ": the times of the steps must ascend");
    }
  }
  if (steps.empty())
  {
    throw InvalidInput(list.where() + ": there are no steps");
  }
  return steps;
}
}

CaseFile readCaseFile(const std::string& path)
{
  const JsonDocument document(path);
  const JsonValue root = document.root();
  root.expectKeys({ "strata", "materials", "volume_fractions", "fields", "steps" });
  if (root.at("strata").number() != supportedVersion)
  {
    throw InvalidInput(root.at("strata").where() + ": this version reads cases of version 1 only");
  }
  CaseFile result;
  result.description.materials = readMaterials(root.at("materials"));
  const strata::Materials& materials = result.description.materials;
  result.description.fractionArrays = readFractions(root.at("volume_fractions"), materials);
  if (root.has("fields"))
  {
    result.description.fields = readFields(root.at("fields"), materials);
  }
  result.steps = readSteps(root.at("steps"), materials, vtksys::SystemTools::GetFilenamePath(path));
  return result;
}
