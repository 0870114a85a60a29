"""Volumes, gaps and open edges of surfaces that nest in the cells of a rectilinear grid.

All four methods work cell by cell, so no triangle leaves its cell. On a line of cells along an axis, start from a
cell that no triangle touches and that one material fills: going on from there, a triangle takes its projected area
from a material that it leaves and adds it to one that it enters. That gives each cell's volumes exactly.
"""
import numpy

PURE = 0.999  # fraction from which on a cell without triangles is taken for filled
POINTS_PER_CELL, MOST_POINTS = 8, 20000


class Measure:
    """Measures what methods make of a case."""

    def __init__(self, case):
        self.case = case
        self.mixed = case.mixed()
        steps = [numpy.diff(axis) for axis in case.axes]
        self.cell_volumes = steps[0][:, None, None] * steps[1][None, :, None] * steps[2][None, None, :]
        self.points, self.point_cells = self.sample(numpy.argwhere(
            (sum((f > 0.01).astype(int) for f in case.fractions) > 2) & ~case.hidden))

    def sample(self, cells):
        """Random points in cells."""
        random = numpy.random.default_rng(1)
        cells = numpy.repeat(cells, POINTS_PER_CELL, axis=0)
        if len(cells) > MOST_POINTS:
            cells = cells[numpy.sort(random.choice(len(cells), MOST_POINTS, replace=False))]
        lower, upper = ([axis[cells[:, i] + side] for i, axis in enumerate(self.case.axes)] for side in (0, 1))
        place = random.random((len(cells), 3))
        return numpy.transpose(lower) + place * (numpy.transpose(upper) - numpy.transpose(lower)), cells

    def cells_of(self, triangles):
        """The cell that each triangle lies in, [triangle, axis]."""
        middles = triangles.mean(axis=1)
        return numpy.stack([numpy.clip(numpy.searchsorted(axis, middles[:, i], side="right") - 1, 0, len(axis) - 2)
                            for i, axis in enumerate(self.case.axes)], axis=1)

    def volumes(self, material, triangles):
        """The material's volume by cell; NaN where no line leads there from a cell that one material fills."""
        cells = self.cells_of(triangles)
        result = numpy.full(self.mixed.shape, numpy.nan)
        for axis in (2, 1, 0):
            along = self.volumes_along(axis, material, triangles, cells)
            result = numpy.where(numpy.isnan(result), along, result)
        return result

    def volumes_along(self, axis, material, triangles, cells):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        edges = triangles[:, 1:] - triangles[:, :1]
        # Area as seen along the axis, positive where one leaves the material on the way up.
        area = 0.5 * (edges[:, 0, first] * edges[:, 1, second] - edges[:, 0, second] * edges[:, 1, first])
        bounds = self.case.axes[axis]
        below = triangles[:, :, axis].mean(axis=1) - bounds[cells[:, axis]]
        flat = numpy.ravel_multi_index(cells.T, self.mixed.shape)
        size = self.mixed.size
        shape = self.mixed.shape
        loss = numpy.bincount(flat, area, size).reshape(shape)
        moment = numpy.bincount(flat, area * below, size).reshape(shape)
        free = numpy.bincount(flat, minlength=size).reshape(shape) == 0
        return self.sweep(axis, material, free, loss, moment)

    def sweep(self, axis, material, free, loss, moment):
        """Carries the material's area on a cell's lower face along the lines of cells, there and back."""
        fraction = numpy.moveaxis(self.case.fractions[material], axis, 0)
        heights = numpy.diff(self.case.axes[axis])
        areas = numpy.moveaxis(self.cell_volumes, axis, 0) / heights[:, None, None]
        free, loss, moment, hidden = (numpy.moveaxis(a, axis, 0) for a in (free, loss, moment, self.case.hidden))
        known = free & ((fraction > PURE) | (fraction < 1.0 - PURE))
        lower = numpy.full(free.shape, numpy.nan)
        for order in (1, -1):
            state = numpy.full(free.shape[1:], numpy.nan)
            for k in range(len(heights))[::order]:
                # `state` is the area on the face that one comes from.
                state = numpy.where(hidden[k], numpy.nan, state)
                state = numpy.where(known[k], numpy.where(fraction[k] > 0.5, areas[k], 0.0), state)
                at_lower = state if order > 0 else state + loss[k]
                lower[k] = numpy.where(numpy.isnan(lower[k]), at_lower, lower[k])
                state = at_lower - loss[k] if order > 0 else at_lower
        volume = lower * heights[:, None, None] - (loss * heights[:, None, None] - moment)
        return numpy.moveaxis(volume, 0, axis)

    def volume_errors(self, result):
        """Largest and mean error of mixed cells (the worst material, in cells), how many are above 0.01, of how many."""
        worst = numpy.zeros(self.mixed.shape)
        for material, fraction in enumerate(self.case.fractions):
            if result.planes:
                found = self.volumes_of_planes(fraction, *result.planes[material])
            else:
                found = self.volumes(material, result.surfaces[material])
            worst = numpy.maximum(worst, numpy.abs(found / self.cell_volumes - fraction))
        worst = worst[self.mixed & ~numpy.isnan(worst)]
        return worst.max(), worst.mean(), int((worst > 0.01).sum()), len(worst)

    def gaps(self, result):
        """The parts of the points that lie in no and in several materials."""
        if len(self.points) == 0:
            return 0.0, 0.0
        if result.planes:
            inside = [self.inside_planes(f, *p) for f, p in zip(self.case.fractions, result.planes)]
        else:
            inside = [self.inside_surface(m, triangles) for m, triangles in enumerate(result.surfaces)]
        counts = sum(inside)
        counted = ~numpy.isnan(counts)
        return (counts[counted] == 0).mean(), (counts[counted] > 1).mean()

    def inside_planes(self, fraction, cells, planes):
        """1 for the points behind the plane in their cell; cells without a plane are full or empty."""
        planes = self.better_sides(fraction, cells, planes)
        plane_of_cell = numpy.full(self.mixed.size, -1)
        plane_of_cell[cells] = numpy.arange(len(cells))
        found = plane_of_cell[numpy.ravel_multi_index(self.point_cells.T, self.mixed.shape)]
        planes = planes[found]
        behind = (self.points * planes[:, :3]).sum(axis=1) < planes[:, 3]
        return numpy.where(found >= 0, behind, fraction[tuple(self.point_cells.T)] > 0.5).astype(float)

    def volumes_of_planes(self, fraction, cells, planes):
        """The material's volume by cell; cells without a plane are full or empty."""
        planes = self.better_sides(fraction, cells, planes)
        result = numpy.where(fraction > 0.5, self.cell_volumes, 0.0)
        result.ravel()[cells] = self.parts_behind(cells, planes) * self.cell_volumes.ravel()[cells]
        return result

    def better_sides(self, fraction, cells, planes):
        """Planes turned so that the fraction behind them is the nearer one: the filter does not tell the side."""
        behind, given = self.parts_behind(cells, planes), fraction.ravel()[cells]
        return planes * numpy.where(numpy.abs(behind - given) <= numpy.abs(1.0 - behind - given), 1.0, -1.0)[:, None]

    def parts_behind(self, cells, planes):
        """The part of each cell behind its plane: the corners' pyramids, added and taken away."""
        ids = numpy.unravel_index(cells, self.mixed.shape)
        steps = numpy.stack([numpy.diff(axis)[i] for axis, i in zip(self.case.axes, ids)], axis=1)
        lower = numpy.stack([axis[i] for axis, i in zip(self.case.axes, ids)], axis=1)
        rest = planes[:, 3] - (planes[:, :3] * lower).sum(axis=1)
        # Mirrored so that no component is negative, and none is too small to divide by.
        slopes = planes[:, :3] * steps
        rest = rest - numpy.minimum(slopes, 0.0).sum(axis=1)
        slopes = numpy.maximum(numpy.abs(slopes), 1e-4 * numpy.abs(slopes).max(axis=1, keepdims=True))
        part = sum((-1) ** sum(corner) * numpy.maximum(rest - slopes @ corner, 0.0) ** 3
                   for corner in numpy.ndindex(2, 2, 2)) / (6.0 * slopes.prod(axis=1))
        return numpy.clip(part, 0.0, 1.0)

    def inside_surface(self, material, triangles):
        """1 inside, 0 outside, NaN unknown: parity of the crossings along z from a cell that one material fills."""
        cells = self.cells_of(triangles)
        columns = numpy.ravel_multi_index(cells[:, :2].T, self.mixed.shape[:2])
        order = numpy.argsort(columns, kind="stable")
        triangles, cells, columns = triangles[order], cells[order], columns[order]
        free = numpy.bincount(numpy.ravel_multi_index(cells.T, self.mixed.shape),
                              minlength=self.mixed.size).reshape(self.mixed.shape) == 0
        fraction = self.case.fractions[material]
        known = free & ((fraction > PURE) | (fraction < 1.0 - PURE)) & ~self.case.hidden
        wanted = numpy.ravel_multi_index(self.point_cells[:, :2].T, self.mixed.shape[:2])
        begin, end = (numpy.searchsorted(columns, wanted, side=side) for side in ("left", "right"))
        return numpy.array([self.parity(point, cell, known, fraction, triangles[b:e])
                            for point, cell, b, e in zip(self.points, self.point_cells, begin, end)])

    def parity(self, point, cell, known, fraction, triangles):
        line = known[cell[0], cell[1]]
        starts = numpy.flatnonzero(line)
        if len(starts) == 0:
            return numpy.nan
        k = starts[numpy.abs(starts - cell[2]).argmin()]
        if self.case.hidden[cell[0], cell[1], min(k, cell[2]):max(k, cell[2])].any():
            return numpy.nan
        start = 0.5 * (self.case.axes[2][k] + self.case.axes[2][k + 1])
        a, b, c = (triangles[:, i] - point for i in range(3))
        cross = [p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((b, c), (c, a), (a, b))]
        hit = ((cross[0] > 0) == (cross[1] > 0)) & ((cross[1] > 0) == (cross[2] > 0))
        heights = sum(w[hit] * p[hit, 2] for w, p in zip(cross, (a, b, c))) / sum(w[hit] for w in cross)
        crossings = ((heights > min(start - point[2], 0.0)) & (heights < max(start - point[2], 0.0))).sum()
        return float((fraction[cell[0], cell[1], k] > 0.5) != (crossings % 2 == 1))

    def open_edges(self, result):
        """Edges that an odd number of triangles of a material use, away from the grid's sides and hidden cells."""
        return sum(self.open_edges_of(triangles) for triangles in result.surfaces)

    def open_edges_of(self, triangles):
        if len(triangles) == 0:
            return 0
        scale = 1e-5 * min(numpy.diff(axis).min() for axis in self.case.axes)
        keys = numpy.round(triangles.reshape(-1, 3) / scale).astype(numpy.int64)
        places, ids = numpy.unique(keys, axis=0, return_inverse=True)
        ids = ids.reshape(-1, 3)
        edges = numpy.sort(numpy.concatenate([ids[:, [0, 1]], ids[:, [1, 2]], ids[:, [2, 0]]]), axis=1)
        edges = edges[edges[:, 0] != edges[:, 1]]
        edges, uses = numpy.unique(edges, axis=0, return_counts=True)
        ends = places[edges[uses % 2 == 1]] * scale
        return int((~self.on_side(ends)).sum())

    def on_side(self, ends):
        """Whether both ends of edges lie on the same side of the grid, or beside a hidden cell."""
        result = numpy.zeros(len(ends), dtype=bool)
        for i, axis in enumerate(self.case.axes):
            near = 1e-4 * numpy.diff(axis).min()
            for side in (axis[0], axis[-1]):
                result |= (numpy.abs(ends[:, :, i] - side) < near).all(axis=1)
        if self.case.hidden.any():
            result |= self.beside_hidden(ends.mean(axis=1))
        return result

    def beside_hidden(self, points):
        result = numpy.zeros(len(points), dtype=bool)
        for shift in numpy.ndindex(2, 2, 2):
            cell = []
            for i, axis in enumerate(self.case.axes):
                near = 1e-3 * numpy.diff(axis).min() * (2 * shift[i] - 1)
                cell.append(numpy.clip(numpy.searchsorted(axis, points[:, i] + near) - 1, 0, len(axis) - 2))
            result |= self.case.hidden[tuple(cell)]
        return result
