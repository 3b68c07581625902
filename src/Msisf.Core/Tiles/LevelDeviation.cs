using Msisf.Core.Lod;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>How far the surface of a coarser level lies from the model's.</summary>
public static class LevelDeviation
{
    /// <summary>The maximum difference in height between a part's facets and the model's samples below or above them, m.</summary>
    /// <param name="part">A part of any level; 0 for the model itself.</param>
    public static double Of(LodLevels levels, SurfacePart part)
    {
        if (part.Level == 0)
        {
            return 0.0;
        }

        IGlobalGrid model = levels.Level(0);
        TileMeshLayout layout = TileMeshLayout.For(part, model.PixelsPerDegree);
        int samples = (layout.Samples - 1) << part.Level;
        int firstSample = ((layout.FirstSample << part.Level) + (1 << (part.Level - 1))) % (360 * model.PixelsPerDegree);
        double[] north = new double[layout.Samples];
        double[] south = new double[layout.Samples];
        double[] fine = new double[samples];
        levels.Level(part.Level).ReadRadii(layout.FirstLine, layout.FirstSample, north);
        double worst = 0.0;
        for (int row = 0; row + 1 < layout.Lines; row++)
        {
            levels.Level(part.Level).ReadRadii(layout.FirstLine + row + 1, layout.FirstSample, south);
            int firstLine = ((layout.FirstLine + row) << part.Level) + (1 << (part.Level - 1));
            for (int line = 0; line < 1 << part.Level; line++)
            {
                model.ReadRadii(firstLine + line, firstSample, fine);
                worst = Math.Max(worst, WorstOfLine(north, south, fine, part.Level, line));
            }

            (north, south) = (south, north);
        }

        return worst + Sagitta(layout.PixelsPerDegree);
    }

    /// <summary>
    /// The samples of a line that lie in one row of coarse cells; sample i lies (i + 0.5) / 2^level cells from the first coarse one.
    /// </summary>
    private static double WorstOfLine(double[] north, double[] south, double[] fine, int level, int line)
    {
        int side = 1 << level;
        double down = (line + 0.5) / side;
        double worst = 0.0;
        for (int i = 0; i < fine.Length; i++)
        {
            int cell = i >> level;
            double across = ((i & (side - 1)) + 0.5) / side;
            double northWest = north[cell];
            double southEast = south[cell + 1];

            // The diagonal runs from north-west to south-east.
            double facet = down > across
                ? northWest + (down * (south[cell] - northWest)) + (across * (southEast - south[cell]))
                : northWest + (across * (north[cell + 1] - northWest)) + (down * (southEast - north[cell + 1]));
            worst = Math.Max(worst, Math.Abs(facet - fine[i]));
        }

        return worst;
    }

    /// <summary>Maximum distance by which a flat facet lies below the sphere through its corners, m.</summary>
    private static double Sagitta(int pixelsPerDegree) => MoonConstants.ReferenceRadius * (1.0 - MeshBounds.SagittaFactor(pixelsPerDegree));
}
