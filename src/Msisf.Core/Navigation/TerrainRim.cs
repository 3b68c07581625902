using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Navigation;

/// <summary>Finds the rim of a crater on the terrain: in each direction from its centre the highest ground near the disc's end.</summary>
internal static class TerrainRim
{
    /// <summary>Parts of the way to the disc's border between which the rim is looked for.</summary>
    private const double Nearest = 0.8;

    /// <inheritdoc cref="Nearest"/>
    private const double Farthest = 1.2;

    /// <summary>Places on this way: steps of a 20th of the radius.</summary>
    private const int Places = 9;

    /// <summary>The rim, m, body-fixed.</summary>
    /// <param name="directions">How many points.</param>
    public static Vector3D[] Of(in CraterDisc disc, ITerrain terrain, int directions)
    {
        Vector3D[] rim = new Vector3D[directions];
        for (int i = 0; i < directions; i++)
        {
            Vector3D way = disc.RimAt(2.0 * Math.PI * i / directions) - disc.Centre;
            double highest = double.NegativeInfinity;
            for (int place = 0; place < Places; place++)
            {
                double part = Nearest + ((Farthest - Nearest) * place / (Places - 1));
                Vector3D direction = (disc.Centre + (part * way)).Normalized();
                double radius = TerrainHeight.RadiusBelow(terrain, direction);
                if (radius > highest)
                {
                    (highest, rim[i]) = (radius, radius * direction);
                }
            }
        }

        return rim;
    }
}
