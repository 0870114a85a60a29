#include "KeptInterfaces.h"

#include "InterfaceFingerprint.h"

std::shared_ptr<strata::PreparedInterfaces> KeptInterfaces::get(const strata::conversion::CaseData& input,
  vtkDataObject* given, const strata::Simulation& simulation, double minimumVolumeFraction, strata::Warnings& warnings,
  strata::Progress& progress)
{
  const auto find = [&](strata::Warnings& said) {
    return std::make_shared<strata::PreparedInterfaces>(
      originalInterfaces(input, given, simulation, minimumVolumeFraction, said, progress));
  };
  if (given || !input.surfaces.empty())
  {
    interfaces_.reset();
    return find(warnings);
  }
  const std::uint64_t fingerprint = fingerprintOf(simulation, extractOptions(minimumVolumeFraction));
  if (!interfaces_ || fingerprint != fingerprint_)
  {
    interfaces_.reset();
    warnings_.clear();
    interfaces_ = find(warnings_);
    fingerprint_ = fingerprint;
    ++extractions_;
  }
  warnings.insert(warnings.end(), warnings_.begin(), warnings_.end());
  return interfaces_;
}
