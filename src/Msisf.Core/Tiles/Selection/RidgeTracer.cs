using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// Raises a horizon map by the mesh edges of a patch of terrain. Lines of edges (along the rows and the columns of the mesh) are
/// followed from bin to bin; where a line crosses both borders of a bin, the terrain reaches the line's minimum slope between
/// them at every azimuth of the bin.
/// </summary>
internal sealed class RidgeTracer
{
    private readonly HorizonMap _map;
    private readonly PolarView _view;
    private readonly (double Sin, double Cos)[] _borders;
    private readonly double _chordFactor;
    private readonly double _arcMargin;
    private PolarPoint[] _points = [];
    private double[] _places = [];

    // State of the line that is being followed.
    private int _direction;
    private bool _entered;
    private double _min;
    private double _farthest;

    /// <param name="map">The map to raise.</param>
    /// <param name="view">The viewpoint's half planes.</param>
    /// <param name="cellAngle">Edge of a mesh cell, rad.</param>
    public RidgeTracer(HorizonMap map, PolarView view, double cellAngle)
    {
        _map = map;
        _view = view;
        _borders = new (double, double)[map.Window.Bins + 1];
        for (int bin = 0; bin <= map.Window.Bins; bin++)
        {
            _borders[bin] = Math.SinCos(map.Window.Border(bin));
        }

        // A chord is nearer to the axis than its ends, by at most the cosine of half the bin; a negative slope is steeper by this factor.
        _chordFactor = 1.0 / Math.Cos(0.5 * map.Window.BinWidth);

        // An edge can lie a little farther from the axis than its ends when they are beyond a right angle.
        _arcMargin = cellAngle * cellAngle;
    }

    /// <summary>Follows all edges of a patch.</summary>
    public void Trace(TerrainPatch patch)
    {
        Project(patch);
        for (int line = 0; line < patch.Lines; line++)
        {
            Follow(line * patch.Samples, 1, patch.Samples);
        }

        for (int sample = 0; sample < patch.Samples; sample++)
        {
            Follow(sample, patch.Samples, patch.Lines);
        }
    }

    private void Project(TerrainPatch patch)
    {
        ReadOnlySpan<Vector3D> positions = patch.Positions;
        if (_points.Length < positions.Length)
        {
            _points = new PolarPoint[positions.Length];
            _places = new double[positions.Length];
        }

        for (int vertex = 0; vertex < positions.Length; vertex++)
        {
            _points[vertex] = _view.Project(positions[vertex]);
            _places[vertex] = _map.Window.Place(_points[vertex].Azimuth);
        }
    }

    private void Follow(int start, int step, int count)
    {
        _direction = 0;
        double place = _places[start];
        for (int index = 1, from = start; index < count; index++, from += step)
        {
            place = FollowEdge(from, from + step, place);
        }
    }

    /// <returns>The unwrapped place of the edge's end.</returns>
    private double FollowEdge(int from, int to, double place)
    {
        // The difference of azimuths is below half a turn; an edge next to the axis, which could turn by more, is not used.
        double turn = 2.0 * Math.PI / _map.Window.BinWidth;
        double change = _places[to] - place;
        change -= turn * Math.Round(change / turn);
        double end = place + change;
        int direction = change < 0.0 ? -1 : 1;
        if (Math.Abs(change) > 0.25 * turn)
        {
            _direction = 0;
            return end;
        }

        if (direction != _direction)
        {
            _direction = direction;
            _entered = false;
        }

        int border = direction > 0 ? (int)Math.Ceiling(place) : (int)Math.Floor(place);
        int last = direction > 0 ? (int)Math.Floor(end) : (int)Math.Ceiling(end);
        if (!_map.Window.IsFull)
        {
            // Borders that are outside the window need no crossing.
            int edge = direction > 0 ? Math.Max(border, 0) : Math.Min(border, _map.Window.Bins);
            _entered &= edge == border;
            border = edge;
            last = direction > 0 ? Math.Min(last, _map.Window.Bins) : Math.Max(last, 0);
        }

        double farthest = Math.Max(_points[from].Arc, _points[to].Arc) + _arcMargin;
        _farthest = Math.Max(_farthest, farthest);
        for (; direction * (last - border) >= 0; border += direction)
        {
            Cross(_points[from], _points[to], border, farthest);
        }

        if (_entered)
        {
            PolarPoint point = _points[to];
            _min = Math.Min(_min, SafeSlope(point.Rise, point.Across));
        }

        return end;
    }

    private void Cross(in PolarPoint from, in PolarPoint to, int border, double farthest)
    {
        int bins = _map.Window.Bins;
        int index = _map.Window.IsFull ? ((border % bins) + bins) % bins : border;
        (double sin, double cos) = _borders[index];
        double before = _direction * ((from.North * cos) - (from.East * sin));
        double after = _direction * ((to.North * cos) - (to.East * sin));
        if (!(before < -Tolerances.VertexLattice && after > Tolerances.VertexLattice))
        {
            _entered = false; // rounding to the lattice could take the crossing away
            return;
        }

        double part = before / (before - after);
        double along = Math.FusedMultiplyAdd(
            part, ((to.East - from.East) * cos) + ((to.North - from.North) * sin), (from.East * cos) + (from.North * sin));
        double slope = SafeSlope(Math.FusedMultiplyAdd(part, to.Rise - from.Rise, from.Rise), along);
        if (_entered)
        {
            double min = Math.Min(_min, slope);
            _map.Raise(_direction > 0 ? border - 1 : border, _farthest, min < 0.0 ? min * _chordFactor : min);
        }

        _entered = true;
        _min = slope;
        _farthest = farthest;
    }

    /// <summary>A slope that a vertex reaches in spite of rounding.</summary>
    private static double SafeSlope(double rise, double across)
    {
        double slope = rise / across;
        return slope - (Tolerances.VertexLattice * (1.0 + Math.Abs(slope)) / across);
    }
}
