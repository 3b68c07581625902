namespace Msisf.Core.Tiles.Selection;

/// <summary>
/// The parts of the surface that the terrain certainly hides from a viewpoint. For each bin of azimuth and each of some increasing arcs,
/// it holds a slope that the terrain up to that arc reaches at every azimuth of the bin. A point beyond the arc with a smaller slope is
/// hidden.
/// </summary>
internal sealed class HorizonMap
{
    /// <summary>Number of arcs of the map: for the usual span of 10 to 20 degrees a step is as wide as a cell at 4 to 8 px/deg.</summary>
    private const int Rings = 112;

    /// <summary>Slopes, stored bin by bin, so that the data of one bin stay in the processor's cache.</summary>
    private readonly double[] _slopes;
    private readonly double _firstArc;
    private readonly double _ringsPerArc;
    private double _coreArc = double.PositiveInfinity;
    private double _coreSlope;

    /// <param name="window">The azimuths that matter.</param>
    /// <param name="firstArc">Arc before which no surface is ever hidden.</param>
    /// <param name="lastArc">The last arc; terrain beyond it is not used.</param>
    public HorizonMap(AzimuthWindow window, double firstArc, double lastArc)
    {
        Window = window;
        _firstArc = firstArc;
        LastArc = lastArc;
        _ringsPerArc = (Rings - 1) / Math.Max(lastArc - firstArc, 1e-6); // a span of no width is still a span
        _slopes = new double[Rings * window.Bins];
        Array.Fill(_slopes, double.NegativeInfinity);
    }

    public AzimuthWindow Window { get; }

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

    /// <summary>Notes that the Moon reaches a slope at all azimuths, inside the window and outside.</summary>
    /// <param name="farArc">Arc at which the slope is reached.</param>
    public void RaiseAll(double farArc, double slope)
    {
        _coreArc = farArc;
        _coreSlope = slope;
        for (int bin = 0; bin < Window.Bins; bin++)
        {
            Raise(bin, farArc, slope);
        }
    }

    /// <summary>Notes that terrain up to an arc reaches a slope at every azimuth of a bin.</summary>
    /// <param name="bin">
    /// Bin, which may be outside the window: if the window is the whole circle it wraps around, otherwise it is ignored.
    /// </param>
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

        // Slopes rise from ring to ring, so the loop ends at the first one that is high enough.
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
