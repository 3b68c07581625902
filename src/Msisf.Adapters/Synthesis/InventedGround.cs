using Msisf.Core.Terrain;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Gives elevation models their invented detail.</summary>
public static class InventedGround
{
    /// <summary>The ground of models with detail below their resolution.</summary>
    /// <param name="seed">Another seed gives other detail.</param>
    /// <param name="models">The models, the coarsest first; that is one of the whole Moon.</param>
    public static IGroundDetail Of(ulong seed, IReadOnlyList<ITerrainGrid> models) => new GroundDetail(seed, models);
}
