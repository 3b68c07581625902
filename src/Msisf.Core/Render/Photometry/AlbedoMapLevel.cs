namespace Msisf.Core.Render.Photometry;

/// <summary>A level of a map: the same extent with fewer pixels, each the mean of its area.</summary>
/// <param name="Width">Pixels from west to east.</param>
/// <param name="Height">Pixels from north to south.</param>
/// <param name="Codes">The values, row by row from the north-west; 0 is no data, others are linear in the reflectance.</param>
public sealed record AlbedoMapLevel(int Width, int Height, ReadOnlyMemory<ushort> Codes)
{
    /// <summary>The size of the next coarser level; the same size if there is none.</summary>
    public static (int Width, int Height) Below(int width, int height) => ((width + 1) / 2, (height + 1) / 2);
}
