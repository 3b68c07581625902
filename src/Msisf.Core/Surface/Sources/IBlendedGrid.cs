using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>A model that is changed to meet others. Safe for several threads.</summary>
internal interface IBlendedGrid : ITerrainGrid
{
    /// <summary>Whether the height of a sample with data is another one than the model's own.</summary>
    /// <param name="line">The line.</param>
    /// <param name="sample">The sample.</param>
    bool IsBlended(int line, int sample);
}
