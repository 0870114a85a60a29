"""Every filter stops when asked: its output is empty, and it looks at the flag often enough.

What a user waits for after pressing the button is at most the longest time between two looks. It is measured in
processor time of all threads, which other programs don't lengthen; half a second is many times what is needed.
"""
import os
import time

from paraview import simple

TIME = 15.0
LONGEST = 0.5  # seconds
FIRST = "Reading the input"  # stage of every filter


class Watch:
    """Looks at a filter's progress; asks it to stop at a stage."""

    def __init__(self, source, stop_at=None):
        self.filter, self.stop_at = source.GetClientSideObject(), stop_at
        self.filter.SetProgressText("")
        self.looks, self.longest, self.where = 0, 0.0, ""
        self.observers = [self.filter.AddObserver(event, call) for event, call in (
            ("StartEvent", self.begin), ("ProgressEvent", self.look), ("EndEvent", self.measure))]

    def begin(self, *_):
        self.last, self.stage = time.process_time(), "the beginning"

    def measure(self, *_):
        now = time.process_time()
        if now - self.last > self.longest:
            self.longest, self.where = now - self.last, self.stage
        self.last = now

    def look(self, *_):
        self.measure()
        self.looks, self.stage = self.looks + 1, self.filter.GetProgressText()
        if self.stage and self.stage == self.stop_at:
            self.filter.SetAbortExecute(1)

    def end(self):
        for observer in self.observers:
            self.filter.RemoveObserver(observer)


def run(source, stop_at=None):
    watch = Watch(source, stop_at)
    source.MarkModified(source.SMProxy)
    watch.filter.Modified()
    source.UpdatePipeline(TIME)
    watch.end()
    return watch, elements(watch.filter.GetOutputDataObject(0))


def elements(data):
    return data.GetNumberOfElements(data.ROW if data.IsA("vtkTable") else data.CELL)


def check(name, source):
    whole, size = run(source)
    if size == 0 or whole.longest > LONGEST:
        raise AssertionError(f"{name}: {size} elements; {whole.longest:.2f} s without a look at {whole.where}")
    for stage in dict.fromkeys((FIRST, whole.stage)):
        stopped, left = run(source, stage)
        if left != 0 or stopped.longest > LONGEST:
            raise AssertionError(f"{name}, stopped at {stage}: {left} elements are left, "
                                 f"{stopped.longest:.2f} s without a look at {stopped.where}")
    if run(source)[1] != size:
        raise AssertionError(f"{name}: an aborted run changes the next one")
    print(f"{name}: {whole.looks} looks, at most {1000 * whole.longest:.0f} ms between two, at {whole.where}")


def main():
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=vars(simple))
    case = simple.OpenDataFile(os.path.join(os.environ["STRATA_DATA"], "impact", "impact.strata"))
    case.UpdatePipeline(TIME)
    grid = simple.ExtractBlock(Input=case, Selectors=["//grid"])
    mesh = simple.MultiresolutionTetrahedra(Input=case, FieldArrays=["density"], InterfaceErrorBound=0.05)
    check("interfaces", simple.MaterialInterfaces(Input=grid))
    check("tetrahedra", mesh)
    section = simple.MaterialSlice(Input=mesh)
    check("slice", section)
    check("contour", simple.MaterialContour(Input=mesh, ContourBy=["POINTS", "density"], Isosurfaces=[9.0]))
    check("pieces", simple.ExtractMaterials(Input=mesh))
    check("represented interfaces", simple.RepresentedInterfaces(Input=mesh))
    check("samples", simple.SampleRepresentation(Input=mesh, Points=section))
    check("errors", simple.RepresentationError(Input=mesh, Original=case))


main()
