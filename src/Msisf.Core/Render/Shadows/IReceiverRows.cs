namespace Msisf.Core.Render.Shadows;

/// <summary>The receivers of an image, row by row: the surface points of pixels whose facet faces the Sun.</summary>
/// <remarks>Several threads read different rows at the same time. No row is kept: each is computed anew where it is needed again.</remarks>
internal interface IReceiverRows
{
    /// <summary>Number of rows of the image.</summary>
    int Rows { get; }

    /// <summary>Maximum number of receivers in a row: the image's number of columns.</summary>
    int Width { get; }

    /// <summary>Reads the receivers of a row, in any order; once for each row of a frame.</summary>
    /// <param name="row">Row of the image, 0 to <see cref="Rows"/> - 1.</param>
    /// <param name="x">MOON_ME x, m, from the Moon's centre; room for <see cref="Width"/>, as in the other spans.</param>
    /// <param name="y">MOON_ME y, m.</param>
    /// <param name="z">MOON_ME z, m.</param>
    /// <param name="columns">Columns of the image, 0 to <see cref="Width"/> - 1.</param>
    int Read(int row, Span<double> x, Span<double> y, Span<double> z, Span<int> columns);

    /// <summary>Reads some receivers of a row that was read before.</summary>
    /// <param name="row">Row of the image.</param>
    /// <param name="columns">Columns of the receivers that are wanted, ascending; <see cref="Read"/> has returned each of them.</param>
    /// <param name="x">MOON_ME x, m, of each of them.</param>
    /// <param name="y">MOON_ME y, m.</param>
    /// <param name="z">MOON_ME z, m.</param>
    void ReadAgain(int row, ReadOnlySpan<int> columns, Span<double> x, Span<double> y, Span<double> z);
}

/// <summary>Where the points are on which a shadow may be seen.</summary>
internal interface IReceiverBounds
{
    /// <summary>Light space.</summary>
    LightFrame Frame { get; }

    /// <summary>Bounds of all points, m; empty if there are none.</summary>
    LightBox Box { get; }

    /// <summary>Maximum depth of all points, m; minus infinity if there are none.</summary>
    double MaxDepth { get; }

    /// <summary>Upper bound of the depths of the points in a box, m; minus infinity if there are none.</summary>
    double MaxDepthIn(in LightBox box);
}
