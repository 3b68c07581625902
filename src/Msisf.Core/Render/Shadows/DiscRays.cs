using System.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The directions to the points of the Sun's disc in light space. All rays to one of these points are parallel in light space: with each
/// metre towards the Sun they move across by the same (a, b). Adding (a, b) w to (u, v) makes them parallel to the w axis, so each point
/// of the disc can be treated like the disc's centre.
/// </summary>
internal sealed class DiscRays
{
    /// <summary>Dimensionless factor that widens the reach of a sector, so that rounding errors cannot exclude one of its points.</summary>
    private const double ReachMargin = 1.0001;

    /// <summary>Number of masks of a sector's points.</summary>
    private const int SectorMasks = 1 << SunDisc.PointsPerSector;

    private const int Sectors = SunDisc.Points / SunDisc.PointsPerSector;

    private readonly double[] _a = new double[SunDisc.Points];
    private readonly double[] _b = new double[SunDisc.Points];
    private readonly double[] _minA = new double[Sectors * SectorMasks];
    private readonly double _minOfAll;
    private readonly double[] _sectorA = new double[Sectors];
    private readonly double[] _sectorB = new double[Sectors];
    private readonly double[] _sectorReachA = new double[Sectors];
    private readonly double[] _sectorReachB = new double[Sectors];

    public DiscRays(SunDisc disc, LightFrame frame)
    {
        for (int i = 0; i < SunDisc.Points; i++)
        {
            Vector3D offset = disc.PointsBodyFixed[i] - disc.CentreBodyFixed;
            _a[i] = Vector3D.Dot(offset, frame.AxisU) / frame.SunDistance;
            _b[i] = Vector3D.Dot(offset, frame.AxisV) / frame.SunDistance;
        }

        _minOfAll = _a.Min();

        for (int sector = 0; sector < Sectors; sector++)
        {
            Range points = (sector * SunDisc.PointsPerSector)..((sector + 1) * SunDisc.PointsPerSector);
            double a = _a[points].Average();
            double b = _b[points].Average();
            (_sectorA[sector], _sectorB[sector]) = (a, b);
            _minA[sector * SectorMasks] = double.PositiveInfinity;
            for (int mask = 1; mask < SectorMasks; mask++)
            {
                // A mask without its lowest bit comes before it.
                double first = _a[(sector * SunDisc.PointsPerSector) + BitOperations.TrailingZeroCount(mask)];
                _minA[(sector * SectorMasks) + mask] = Math.Min(first, _minA[(sector * SectorMasks) + (mask & (mask - 1))]);
            }

            _sectorReachA[sector] = ReachMargin * _a[points].Max(pa => Math.Abs(pa - a));
            _sectorReachB[sector] = ReachMargin * _b[points].Max(pb => Math.Abs(pb - b));
        }
    }

    /// <summary>Minimum of a (the class's remarks) over some points of the disc.</summary>
    /// <param name="points">Mask of the points; not 0.</param>
    public double MinA(ulong points)
    {
        if (points == SunDisc.All)
        {
            return _minOfAll;
        }

        double min = double.PositiveInfinity;
        for (int sector = 0; sector < Sectors; sector++)
        {
            min = double.MinNative(min, _minA[(sector * SectorMasks) + (byte)(points >> (sector * SunDisc.PointsPerSector))]);
        }

        return min;
    }

    /// <summary>Mask of the points of the disc whose a (the class's remarks) is not above a maximum.</summary>
    public ulong PointsUpTo(double maxA)
    {
        ulong points = 0;
        for (int i = 0; i < SunDisc.Points; i++)
        {
            points |= _a[i] <= maxA ? 1UL << i : 0;
        }

        return points;
    }

    /// <summary>Mask of the points of the disc that facets of eight neighbouring cells of a line hide from a point.</summary>
    /// <param name="vertices">Vertices of a block in light space, m.</param>
    /// <param name="northWest">Index of the first cell's north-western vertex.</param>
    /// <param name="southWest">Mask of the cells whose facet (NW, SW, SE) is tested.</param>
    /// <param name="northEast">Mask of the cells whose facet (NW, SE, NE) is tested.</param>
    /// <param name="point">The point in light space, m.</param>
    /// <param name="wanted">Mask of the points of the disc to test.</param>
    public ulong HiddenBy(BlockVertices vertices, int northWest, uint southWest, uint northEast, Vector3D point, ulong wanted)
    {
        CellRays cells = new(vertices, northWest, point);
        southWest &= cells.SouthWestInFront;
        northEast &= cells.NorthEastInFront;
        if ((southWest | northEast) == 0)
        {
            return 0;
        }

        ulong hidden = 0;
        for (int sector = 0; sector < Sectors; sector++)
        {
            int first = sector * SunDisc.PointsPerSector;
            uint left = (byte)(wanted >> first);
            if (left == 0 || !cells.MayHold(
                _sectorA[sector], _sectorB[sector], _sectorReachA[sector], _sectorReachB[sector], southWest, northEast))
            {
                continue;
            }

            for (; left != 0; left &= left - 1)
            {
                int i = first + BitOperations.TrailingZeroCount(left);
                hidden |= cells.AnyHolds(_a[i], _b[i], southWest, northEast) ? 1UL << i : 0;
            }
        }

        return hidden;
    }
}
