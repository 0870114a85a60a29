/**
 * @class vtkStrataTetrahedra
 * @brief refines a simulation into tetrahedra whose errors stay within bounds
 *
 * Input port 0 takes a grid or a case (a collection with a block `grid` and interface surfaces), port 1 optional
 * interface surfaces. The output is the representation: a conforming mesh of tetrahedra with a distance and field
 * values per material at its vertices. The hierarchy is kept while the input and the build options stay, so that a
 * change of bounds selects another level without reading the input again.
 */
#ifndef vtkStrataTetrahedra_h
#define vtkStrataTetrahedra_h

#include "vtkStrataFiltersModule.h" // for the export macro
#include "vtkStrataSimulationFilter.h"

#include <string>

class VTKSTRATAFILTERS_EXPORT vtkStrataTetrahedra : public vtkStrataSimulationFilter
{
public:
  static vtkStrataTetrahedra* New();
  vtkTypeMacro(vtkStrataTetrahedra, vtkStrataSimulationFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Fields, or arrays of fields, to represent; none: the active scalars' field, else by its name (User guide). */
  void AddFieldArray(const char* name);
  void ClearFieldArrays();
  ///@}

  ///@{
  /** Largest distance of an interface to its representation; 0: half a per cent of the box's diagonal. */
  vtkSetMacro(InterfaceErrorBound, double);
  vtkGetMacro(InterfaceErrorBound, double);
  ///@}

  ///@{
  /** Largest error of a field in units of its range. */
  vtkSetMacro(FieldErrorBound, double);
  vtkGetMacro(FieldErrorBound, double);
  ///@}

  ///@{
  /** Bounds of single fields in their own units; they win over FieldErrorBound. */
  void AddAbsoluteFieldErrorBound(const char* field, double bound);
  void ClearAbsoluteFieldErrorBounds();
  ///@}

  ///@{
  /** Bounds down to which saturated and accumulated errors look; 0: no deeper than the bounds themselves. */
  vtkSetMacro(FinestInterfaceErrorBound, double);
  vtkGetMacro(FinestInterfaceErrorBound, double);
  vtkSetMacro(FinestFieldErrorBound, double);
  vtkGetMacro(FinestFieldErrorBound, double);
  ///@}

  ///@{
  /** Stop at MaximumNumberOfCells. */
  vtkSetMacro(LimitCells, bool);
  vtkGetMacro(LimitCells, bool);
  vtkBooleanMacro(LimitCells, bool);
  vtkSetMacro(MaximumNumberOfCells, vtkIdType);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  ///@{
  /** Largest number of bisections below the base mesh. */
  vtkSetMacro(MaximumLevel, int);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /** Cubes of the base mesh along each axis. */
  vtkSetVector3Macro(BaseCubes, int);
  vtkGetVector3Macro(BaseCubes, int);
  ///@}

  ///@{
  /** Materials to refine for: cells with none of them are only as fine as conformity asks; none: all. */
  void AddFocusMaterial(const char* name);
  void ClearFocusMaterials();
  ///@}

  enum RegionOfInterestType
  {
    NONE = 0,
    BOX = 1,
    SPHERE = 2
  };

  ///@{
  /** A part of space outside of which the bounds are RegionCoarsening (at least 1) times as large. */
  vtkSetClampMacro(RegionOfInterest, int, NONE, SPHERE);
  vtkGetMacro(RegionOfInterest, int);
  vtkSetVector6Macro(RegionBounds, double);
  vtkGetVector6Macro(RegionBounds, double);
  vtkSetVector3Macro(RegionCenter, double);
  vtkGetVector3Macro(RegionCenter, double);
  vtkSetMacro(RegionRadius, double);
  vtkGetMacro(RegionRadius, double);
  vtkSetMacro(RegionCoarsening, double);
  vtkGetMacro(RegionCoarsening, double);
  ///@}

  ///@{
  /** Refine for the picture of a perspective camera: interface errors up to PixelErrorBound on the screen are allowed,
   * and what is not seen sets no demands. The view angle is vertical, in degrees; the aspect is width / height. */
  vtkSetMacro(ViewDependent, bool);
  vtkGetMacro(ViewDependent, bool);
  vtkBooleanMacro(ViewDependent, bool);
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
  vtkSetVector3Macro(CameraViewUp, double);
  vtkGetVector3Macro(CameraViewUp, double);
  vtkSetMacro(CameraViewAngle, double);
  vtkGetMacro(CameraViewAngle, double);
  vtkSetMacro(ImageHeight, int);
  vtkGetMacro(ImageHeight, int);
  vtkSetMacro(ImageAspect, double);
  vtkGetMacro(ImageAspect, double);
  vtkSetMacro(PixelErrorBound, double);
  vtkGetMacro(PixelErrorBound, double);
  ///@}

  enum NativeElementsType
  {
    POINTS = 0,
    CELLS = 1
  };
  enum DistanceMethodType
  {
    CLOSEST_POINT = 0,
    CLOSEST_VERTEX = 1
  };
  enum GhostMethodType
  {
    DATA_THEN_LINEAR = 0,
    LINEAR = 1,
    CONSTANT = 2
  };
  enum ErrorMethodType
  {
    DIRECT = 0,
    SATURATED = 1,
    FITTED = 2,
    ACCUMULATED = 3
  };
  enum PassArraysType
  {
    ALL = 0,
    WITHOUT_GHOSTS = 1,
    COMPOSITE_ONLY = 2
  };

  ///@{
  /** Whether errors are bounded at the data's points or over whole cells. */
  vtkSetClampMacro(NativeElements, int, POINTS, CELLS);
  vtkGetMacro(NativeElements, int);
  ///@}

  ///@{
  /** How distances to materials are found. */
  vtkSetClampMacro(DistanceMethod, int, CLOSEST_POINT, CLOSEST_VERTEX);
  vtkGetMacro(DistanceMethod, int);
  ///@}

  ///@{
  /** How fields continue past their material's interface. */
  vtkSetClampMacro(GhostMethod, int, DATA_THEN_LINEAR, CONSTANT);
  vtkGetMacro(GhostMethod, int);
  ///@}

  ///@{
  /** How a cell's error follows from its own and its descendants'. */
  vtkSetClampMacro(ErrorMethod, int, DIRECT, ACCUMULATED);
  vtkGetMacro(ErrorMethod, int);
  ///@}

  ///@{
  /** Which arrays the output carries. */
  vtkSetClampMacro(PassArrays, int, ALL, COMPOSITE_ONLY);
  vtkGetMacro(PassArrays, int);
  ///@}

  ///@{
  /** What the last run achieved. */
  vtkGetMacro(AchievedInterfaceError, double);
  double GetAchievedFieldError(int field) const;
  int GetNumberOfAchievedFieldErrors() const;
  const char* GetAchievedFieldErrors() const;
  vtkGetMacro(NumberOfCells, vtkIdType);
  vtkGetMacro(BoundMet, bool);
  const char* GetStoppedBy() const;
  /** Time that the last run took. */
  vtkGetMacro(Seconds, double);
  /** How often the hierarchy was built anew since the filter was made. */
  vtkGetMacro(NumberOfBuilds, int);
  /** How often interfaces were extracted since then: builds in which fields alone change share them. */
  vtkGetMacro(NumberOfExtractions, int);
  ///@}

  /** What the numbers of the output's cell array `material` stand for, a line "<number><tab><name>" each. */
  std::string GetLegend();

protected:
  vtkStrataTetrahedra();
  ~vtkStrataTetrahedra() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double InterfaceErrorBound = 0.0;
  double FieldErrorBound = 0.01;
  double FinestInterfaceErrorBound = 0.0;
  double FinestFieldErrorBound = 0.0;
  bool LimitCells = false;
  vtkIdType MaximumNumberOfCells = 1000000;
  int MaximumLevel = 60;
  int BaseCubes[3] = { 1, 1, 1 };
  int NativeElements = POINTS;
  int DistanceMethod = CLOSEST_POINT;
  int GhostMethod = DATA_THEN_LINEAR;
  int ErrorMethod = DIRECT;
  int PassArrays = ALL;
  int RegionOfInterest = NONE;
  double RegionBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  double RegionCenter[3] = { 0.0, 0.0, 0.0 };
  double RegionRadius = 1.0;
  double RegionCoarsening = 10.0;
  bool ViewDependent = false;
  double CameraPosition[3] = { 0.0, 0.0, 1.0 };
  double CameraFocalPoint[3] = { 0.0, 0.0, 0.0 };
  double CameraViewUp[3] = { 0.0, 1.0, 0.0 };
  double CameraViewAngle = 30.0;
  int ImageHeight = 1000;
  double ImageAspect = 1.0;
  double PixelErrorBound = 1.0;
  double AchievedInterfaceError = 0.0;
  vtkIdType NumberOfCells = 0;
  bool BoundMet = false;
  double Seconds = 0.0;
  int NumberOfBuilds = 0;
  int NumberOfExtractions = 0;

private:
  vtkStrataTetrahedra(const vtkStrataTetrahedra&) = delete;
  void operator=(const vtkStrataTetrahedra&) = delete;

  struct Internals;
  std::unique_ptr<Internals> State;
};

#endif
