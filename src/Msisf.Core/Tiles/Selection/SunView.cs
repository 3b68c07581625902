using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>The Moon as seen from the Sun: ground that the Sun certainly does not reach is dark.</summary>
internal sealed class SunView
{
    /// <summary>Number of azimuth bins of the list of tiles that need the map.</summary>
    private const int NeedBins = 360;

    /// <summary>
    /// Arc (see <see cref="PolarPoint.Arc"/>), some 8 degrees at the limb: terrain that is nearer to the Sun's axis by more than this is
    /// hardly high enough to hide anything.
    /// </summary>
    private const double Reach = 0.05;

    private readonly double[] _needNear = new double[NeedBins];
    private readonly double[] _needFar = new double[NeedBins];
    private readonly AzimuthWindow _needs = new(0.0, 2.0 * Math.PI, 2.0 * Math.PI / NeedBins, NeedBins);

    /// <param name="sunBodyFixed">m, body-fixed.</param>
    /// <param name="summary">Bounds of the terrain.</param>
    /// <param name="patch">Buffer for reading terrain.</param>
    /// <param name="tiles">The tiles whose light matters.</param>
    public SunView(Vector3D sunBodyFixed, ElevationSummary summary, TerrainPatch patch, IEnumerable<TileId> tiles)
    {
        Position = sunBodyFixed;
        View = new PolarView(sunBodyFixed);
        Table = new BoundsTable(View, summary);
        HorizonSurvey survey = new(View, summary, patch);
        Array.Fill(_needNear, double.PositiveInfinity);
        HorizonMap limits = survey.EmptyMap(0.0, 0.0);
        foreach (TileId tile in tiles)
        {
            PolarBounds bounds = Table.Possible(tile); // arcs and azimuths, which no height changes
            if (bounds.Near < limits.LastArc && !limits.NeverHides(bounds))
            {
                Note(bounds);
            }
        }

        (double middle, double width) = Span();
        Map = survey.EmptyMap(middle, width);
        if (width > 0.0)
        {
            survey.Fill(Map, (in TerrainNode _, in PolarBounds bounds) => IsNeeded(bounds));
        }
    }

    /// <summary>Position of the Sun, m, body-fixed.</summary>
    public Vector3D Position { get; }

    /// <summary>Half planes about the axis to the Sun.</summary>
    public PolarView View { get; }

    /// <summary>Bounds of all tiles.</summary>
    public BoundsTable Table { get; }

    /// <summary>The surface that the terrain hides from the Sun.</summary>
    public HorizonMap Map { get; }

    private void Note(in PolarBounds bounds)
    {
        (int first, int count) = _needs.Touched(bounds.Azimuth, bounds.HalfWidth);
        for (int bin = first; bin < first + count; bin++)
        {
            int index = ((bin % NeedBins) + NeedBins) % NeedBins;
            _needNear[index] = Math.Min(_needNear[index], bounds.Near);
            _needFar[index] = Math.Max(_needFar[index], bounds.Far);
        }
    }

    private bool IsNeeded(in PolarBounds bounds)
    {
        (int first, int count) = _needs.Touched(bounds.Azimuth, bounds.HalfWidth);
        for (int bin = first; bin < first + count; bin++)
        {
            int index = ((bin % NeedBins) + NeedBins) % NeedBins;
            if (bounds.Near < _needFar[index] && bounds.Far > _needNear[index] - Reach)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The range of azimuths that is needed: the circle without its widest unused gap.</summary>
    private (double Middle, double Width) Span()
    {
        int gap = 0;
        int widest = 0;
        int endOfWidest = 0;
        for (int bin = 0; bin < 2 * NeedBins; bin++)
        {
            gap = _needNear[bin % NeedBins] < double.PositiveInfinity ? 0 : gap + 1;
            if (gap > widest)
            {
                widest = gap;
                endOfWidest = bin + 1;
            }
        }

        int used = Math.Max(0, NeedBins - widest);
        return (_needs.Border(endOfWidest) + (0.5 * used * _needs.BinWidth), used * _needs.BinWidth);
    }
}
