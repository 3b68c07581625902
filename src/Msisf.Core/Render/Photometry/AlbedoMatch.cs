namespace Msisf.Core.Render.Photometry;

/// <summary>Makes a map of a part of the Moon as bright as a coarser map is along its border.</summary>
public static class AlbedoMatch
{
    /// <summary>px: the border is that of a level of at most this width and height: noise of single pixels does not count.</summary>
    private const int MaxSide = 256;

    /// <summary>Share of the border's pixels that a coarser map must show.</summary>
    private const double LeastShare = 0.5;

    /// <summary>Finds the finest coarser map that shows at least half of a map's border.</summary>
    /// <param name="coarser">Coarser maps, the finest first.</param>
    /// <returns>That map, and its mean reflectance along the border over that of the map itself; null if there is none.</returns>
    public static (AlbedoMap Around, double Factor)? Of(AlbedoMap site, IEnumerable<AlbedoMap> coarser)
    {
        int level = Enumerable.Range(0, site.Levels.Count).First(
            k => Math.Max(site.Levels[k].Width, site.Levels[k].Height) <= MaxSide);
        List<(double X, double Y, int Code)> border = BorderOf(site, site.Levels[level]);
        foreach (AlbedoMap around in coarser)
        {
            // The level of the other map whose pixels are as large, or its finest.
            double side = site.Extent.Height / site.Levels[level].Height;
            double ratio = side * around.Levels[0].Height / around.Extent.Height;
            MapLevelReader reader = new(around, ratio > 1.0 ? Math.Min(Math.ILogB(ratio), around.Levels.Count - 1) : 0);
            (double own, double other, int count) = (0.0, 0.0, 0);
            foreach ((double x, double y, int code) in border)
            {
                if (CodeOf(around, reader, site.Extent.West + x, site.Extent.North - y) is > 0.0 and double found)
                {
                    own += site.Offset + (site.Step * code);
                    other += around.Offset + (around.Step * found);
                    count++;
                }
            }

            if (count > 0 && count >= LeastShare * border.Count)
            {
                return (around, other / own);
            }
        }

        return null;
    }

    private static double CodeOf(AlbedoMap map, in MapLevelReader reader, double longitude, double latitude)
    {
        double right = longitude - map.Extent.West;
        right -= 2.0 * Math.PI * Math.Floor(right / (2.0 * Math.PI));
        double down = map.Extent.North - latitude;
        return right > map.Extent.Width || down < 0.0 || down > map.Extent.Height
            ? 0.0
            : reader.At(right / map.Extent.Width * map.Levels[0].Width, down / map.Extent.Height * map.Levels[0].Height);
    }

    /// <summary>Pixels with data beside ones without, or at the map's edge: middles, rad from its left upper corner, and codes.</summary>
    private static List<(double X, double Y, int Code)> BorderOf(AlbedoMap map, AlbedoMapLevel level)
    {
        ReadOnlySpan<ushort> codes = level.Codes.Span;
        (double across, double down) = (map.Extent.Width / level.Width, map.Extent.Height / level.Height);
        List<(double X, double Y, int Code)> border = [];
        for (int row = 0; row < level.Height; row++)
        {
            bool isAtEdge = (row == 0 && !map.Extent.ReachesNorthPole) || (row == level.Height - 1 && !map.Extent.ReachesSouthPole);
            for (int column = 0; column < level.Width; column++)
            {
                int index = (row * level.Width) + column;
                bool isAtSide = !map.Extent.IsFullCircle && (column == 0 || column == level.Width - 1);
                bool isBesideNone = codes[(row * level.Width) + ((column + 1) % level.Width)] == 0
                    || codes[(row * level.Width) + ((column + level.Width - 1) % level.Width)] == 0
                    || codes[(Math.Max(row - 1, 0) * level.Width) + column] == 0
                    || codes[(Math.Min(row + 1, level.Height - 1) * level.Width) + column] == 0;
                if (codes[index] != 0 && (isAtEdge || isAtSide || isBesideNone))
                {
                    border.Add(((column + 0.5) * across, (row + 0.5) * down, codes[index]));
                }
            }
        }

        return border;
    }
}
