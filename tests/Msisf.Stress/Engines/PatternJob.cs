using Msisf.Adapters.Tiles;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Stress.Engines;

/// <summary>Patterns that both writers make.</summary>
/// <param name="Grid">The model, for the C# writer.</param>
/// <param name="Image">The same model as 16-bit samples of 0.5 m, for the PHP writer.</param>
/// <param name="Format">Form of the mesh.</param>
/// <param name="MarginSamples">Rings of cells around each tile.</param>
/// <param name="Tiles">By latitude, then longitude.</param>
internal sealed record PatternJob(
    IGlobalGrid Grid, string Image, PatternFormat Format, int MarginSamples, IReadOnlyList<TileId> Tiles);
