namespace Msisf.Core.Render.Shadows;

/// <summary>The points of an image that may be lit: surface points of pixels whose facet faces the Sun, row by row.</summary>
/// <remarks>Each row is read once a frame; several threads read different rows at the same time.</remarks>
internal interface IReceiverRows
{
    /// <summary>Rows of the image.</summary>
    int Rows { get; }

    /// <summary>Most receivers a row.</summary>
    int Width { get; }

    /// <summary>The receivers of a row, in any order.</summary>
    /// <param name="row">0 to <see cref="Rows"/> - 1.</param>
    /// <param name="x">MOON_ME x, m, from the Moon's centre; room for <see cref="Width"/>, as in the other spans.</param>
    /// <param name="y">MOON_ME y, m.</param>
    /// <param name="z">MOON_ME z, m.</param>
    /// <param name="columns">0 to <see cref="Width"/> - 1.</param>
    /// <returns>How many.</returns>
    int Read(int row, Span<double> x, Span<double> y, Span<double> z, Span<int> columns);
}
