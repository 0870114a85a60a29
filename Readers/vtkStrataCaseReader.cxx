#include "vtkStrataCaseReader.h"

#include "CaseFile.h"
#include "CaseOutput.h"

#include "Conversion/Guarded.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>

namespace conversion = strata::conversion;

vtkStandardNewMacro(vtkStrataCaseReader);

struct vtkStrataCaseReader::Internals
{
  CaseFile file;

  /// The last step that is not after the time asked for, or the first.
  const CaseFile::Step& stepAt(vtkInformation* info) const
  {
    if (!info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
    {
      return this->file.steps.front();
    }
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const auto after = std::upper_bound(this->file.steps.begin(), this->file.steps.end(), time,
      [](double wanted, const CaseFile::Step& step) { return wanted < step.time; });
    return after == this->file.steps.begin() ? *after : *std::prev(after);
  }
};

vtkStrataCaseReader::vtkStrataCaseReader() : State(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

vtkStrataCaseReader::~vtkStrataCaseReader()
{
  this->SetFileName(nullptr);
}

int vtkStrataCaseReader::CanReadFile(const char* name)
{
  return vtksys::SystemTools::GetFilenameLastExtension(name ? name : "") == ".strata" ? 1 : 0;
}

int vtkStrataCaseReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  return conversion::guarded(this, vtkDataObject::GetData(outputs), [&](strata::Progress&) {
    if (!this->FileName || !*this->FileName)
    {
      throw strata::InvalidInput("No file name is given");
    }
    this->State->file = readCaseFile(this->FileName);
    std::vector<double> times;
    for (const CaseFile::Step& step : this->State->file.steps)
    {
      times.push_back(step.time);
    }
    const double range[2] = { times.front(), times.back() };
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  });
}

int vtkStrataCaseReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  auto* output = vtkPartitionedDataSetCollection::GetData(outputs);
  return conversion::guarded(this, output, [&](strata::Progress& progress) {
    const CaseFile::Step& step = this->State->stepAt(outputs->GetInformationObject(0));
    conversion::warn(this, readStep(this->State->file, step, output, progress));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.time);
  });
}

void vtkStrataCaseReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
