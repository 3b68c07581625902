using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>An equirectangular map in a file, row by row. Not safe for several threads.</summary>
internal abstract class MapSource : IDisposable
{
    /// <summary>Pixels from west to east.</summary>
    public abstract int Width { get; }

    /// <summary>Pixels from north to south.</summary>
    public abstract int Height { get; }

    /// <summary>What the map shows; null if the file does not say.</summary>
    public abstract MapExtent? Extent { get; }

    /// <summary>The stored values are whole numbers from 0 to 255.</summary>
    public abstract bool IsBytes { get; }

    /// <summary>Reads whole rows.</summary>
    /// <param name="first">The first row, from 0.</param>
    /// <param name="count">How many.</param>
    /// <param name="values">Receives the stored values, row by row; NaN where there is no data.</param>
    /// <exception cref="Core.Errors.BadInputException">The file is damaged.</exception>
    public abstract void Read(int first, int count, Span<float> values);

    /// <summary>Closes the file.</summary>
    public abstract void Dispose();
}
