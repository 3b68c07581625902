namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// What the terrain surely hides from a viewpoint: for each bin of azimuth and each of some rising arcs, a slope that the terrain up to
/// that arc reaches at every azimuth of the bin. A point beyond the arc that is seen under a lesser slope is hidden.
/// </summary>
internal sealed class HorizonMap
{
    /// <summary>Arcs of the map: with the usual span of 10 to 20 degrees a step is as wide as a cell at 4 to 8 px/deg.</summary>
    private const int Rings = 112;

    /// <summary>Bin by bin, so that raising a bin stays in the cache.</summary>
    private readonly double[] _slopes;
    private readonly double _firstArc;
    private readonly double _ringsPerArc;
    private double _coreArc = double.PositiveInfinity;
    private double _coreSlope;

    /// <param name="window">The azimuths that matter.</param>
    /// <param name="firstArc">Nothing before this arc is ever hidden.</param>
    /// <param name="lastArc">The last arc; terrain behind it is of no use for hiding.</param>
    public HorizonMap(AzimuthWindow window, double firstArc, double lastArc)
    {
        Window = window;
        _firstArc = firstArc;
        LastArc = lastArc;
        _ringsPerArc = (Rings - 1) / Math.Max(lastArc - firstArc, 1e-6); // a span of no width is still a span
        _slopes = new double[Rings * window.Bins];
        Array.Fill(_slopes, double.NegativeInfinity);
    }

    /// <summary>The azimuths of the map.</summary>
    public AzimuthWindow Window { get; }

    /// <summary>The last arc.</summary>
    public double LastArc { get; }

    /// <summary>Whether a piece of the surface lies wholly before the first arc, so that more terrain would change nothing.</summary>
    public bool NeverHides(in PolarBounds bounds) => bounds.Far < _firstArc;

    /// <summary>Whether no ray from the viewpoint within the window's azimuths reaches any point within the bounds.</summary>
    public bool Hides(in PolarBounds bounds)
    {
        if (bounds.Near >= _coreArc && bounds.MaxSlope < _coreSlope)
        {
            return true;
        }

        double ring = Math.Floor((bounds.Near - _firstArc) * _ringsPerArc);
        if (!(ring >= 0.0))
        {
            return false;
        }

        (int first, int count) = Window.Touched(bounds.Azimuth, bounds.HalfWidth);
        return count > 0 && IsReached((int)Math.Min(ring, Rings - 1), first, count, bounds.MaxSlope);
    }

    /// <summary>Whether an occluder with this bound could raise the map anywhere.</summary>
    public bool CouldRise(in PolarBounds bounds)
    {
        double ring = Math.Ceiling((bounds.Far - _firstArc) * _ringsPerArc);
        (int first, int count) = Window.Touched(bounds.Azimuth, bounds.HalfWidth);
        return count > 0 && ring < Rings && !IsReached((int)Math.Max(ring, 0.0), first, count, bounds.MaxSlope);
    }

    /// <summary>Notes that everywhere, inside the window and outside, the Moon reaches a slope.</summary>
    /// <param name="farArc">At this arc.</param>
    /// <param name="slope">The slope.</param>
    public void RaiseAll(double farArc, double slope)
    {
        _coreArc = farArc;
        _coreSlope = slope;
        for (int bin = 0; bin < Window.Bins; bin++)
        {
            Raise(bin, farArc, slope);
        }
    }

    /// <summary>Notes that at every azimuth of a bin terrain not farther than an arc reaches a slope.</summary>
    /// <param name="bin">May be outside: a full window goes round, another ignores it.</param>
    /// <param name="farArc">Maximum arc of the terrain.</param>
    /// <param name="slope">Minimum slope of the terrain.</param>
    public void Raise(int bin, double farArc, double slope)
    {
        int bins = Window.Bins;
        if (Window.IsFull)
        {
            bin = ((bin % bins) + bins) % bins;
        }

        double ring = Math.Ceiling((farArc - _firstArc) * _ringsPerArc);
        if ((uint)bin >= (uint)bins || ring >= Rings)
        {
            return;
        }

        // Slopes rise from ring to ring, so the first that is high enough ends the work.
        Span<double> slopes = _slopes.AsSpan(bin * Rings, Rings);
        for (int index = (int)Math.Max(ring, 0.0); index < slopes.Length && slopes[index] < slope; index++)
        {
            slopes[index] = slope;
        }
    }

    private bool IsReached(int ring, int first, int count, double slope)
    {
        int bins = Window.Bins;
        int index = ((((first % bins) + bins) % bins) * Rings) + ring;
        for (; count > 0; count--)
        {
            if (!(slope < _slopes[index]))
            {
                return false;
            }

            index += Rings;
            index = index < _slopes.Length ? index : index - _slopes.Length;
        }

        return true;
    }
}
