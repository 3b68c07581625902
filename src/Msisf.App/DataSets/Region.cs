using Msisf.Core.Terrain;

namespace Msisf.App.DataSets;

/// <summary>A region between two parallels and two meridians, in degrees.</summary>
/// <param name="South">At least -90.</param>
/// <param name="North">Above <paramref name="South"/>, at most 90.</param>
/// <param name="East">Above <paramref name="West"/> by at most 360.</param>
internal readonly record struct Region(double South, double North, double West, double East)
{
    private const double FullTurn = 360.0;

    /// <summary>Its part of the sphere.</summary>
    public double Area => (SineOf(North) - SineOf(South)) * (East - West) / (2.0 * FullTurn);

    /// <summary>A place in it; places are uniform over its area.</summary>
    /// <param name="x">From west to east, [0, 1).</param>
    /// <param name="y">From south to north, [0, 1).</param>
    /// <returns>Latitude and longitude, degrees.</returns>
    public (double Latitude, double Longitude) At(double x, double y)
    {
        double sine = SineOf(South) + (y * (SineOf(North) - SineOf(South)));
        double latitude = double.RadiansToDegrees(Math.Atan2(sine, Math.Sqrt((1.0 - sine) * (1.0 + sine))));
        return (Math.Clamp(latitude, South, North), West + (x * (East - West)));
    }

    /// <summary>Whether a point lies in it.</summary>
    public bool Contains(Vector3D pointBodyFixed)
    {
        SelenographicPoint point = SelenographicPoint.Below(pointBodyFixed);
        double latitude = double.RadiansToDegrees(point.Latitude);
        return latitude >= South && latitude <= North && EastOf(West, double.RadiansToDegrees(point.Longitude)) <= East - West;
    }

    /// <summary>Whether two have a point in common, if only of their borders.</summary>
    public bool Touches(Region other) => South <= other.North && other.South <= North
        && (EastOf(West, other.West) <= East - West || EastOf(other.West, West) <= other.East - other.West);

    /// <summary>How far a meridian lies east of another one, [0, 360).</summary>
    private static double EastOf(double from, double to) => to - from - (FullTurn * Math.Floor((to - from) / FullTurn));

    private static double SineOf(double degrees) => Math.Sin(double.DegreesToRadians(degrees));
}

/// <summary>A part of a data set, as for training, and the regions that it shows.</summary>
/// <param name="Count">Number of images, or of pairs.</param>
/// <param name="Regions">At least one; none touches one of another split.</param>
/// <param name="IsBound">Whether its images may show nothing beyond one of the regions.</param>
internal sealed record Split(string Name, int Count, IReadOnlyList<Region> Regions, bool IsBound)
{
    /// <summary>A place in one of the regions, and that region.</summary>
    /// <param name="x">[0, 1): chooses the region, too.</param>
    /// <param name="y">[0, 1).</param>
    public ((double Latitude, double Longitude) Place, Region Region) At(double x, double y)
    {
        double left = x * Regions.Sum(region => region.Area);
        foreach (Region region in Regions.SkipLast(1))
        {
            if (left < region.Area)
            {
                return (region.At(left / region.Area, y), region);
            }

            left -= region.Area;
        }

        return (Regions[^1].At(Math.Clamp(left / Regions[^1].Area, 0.0, 1.0), y), Regions[^1]);
    }

    /// <summary>
    /// Which split each image, or pair, belongs to: the one that lacks most of its part of all so far. So the first images belong to the
    /// same splits, however many follow.
    /// </summary>
    /// <param name="parts">Share of each split; their sum is 1.</param>
    public static int[] OrderOf(IReadOnlyList<double> parts, int count)
    {
        int[] order = new int[count];
        int[] given = new int[parts.Count];
        for (int number = 0; number < count; number++)
        {
            int most = 0;
            for (int split = 1; split < given.Length; split++)
            {
                if (Lack(split) > Lack(most))
                {
                    most = split;
                }
            }

            order[number] = most;
            given[most]++;

            double Lack(int split) => (parts[split] * (number + 1)) - given[split];
        }

        return order;
    }
}
