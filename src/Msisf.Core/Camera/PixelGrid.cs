namespace Msisf.Core.Camera;

/// <summary>
/// The pixels of an image that get metadata: every multiple of the spacing, so with 50 px the pixels 50, 100, 150, ... as in the
/// example of thesis section 9.2. Pixel 1 is one of them only at spacing 1, which takes every pixel; a spacing larger than the
/// image takes none.
/// </summary>
public sealed class PixelGrid
{
    /// <summary>px: the spacing that the published example has (thesis section 9.3; docs/deviations.md, row 17).</summary>
    public const int DefaultSpacing = 50;

    /// <summary>Lays a grid over an image.</summary>
    /// <param name="width">Image width, px, at least 1.</param>
    /// <param name="height">Image height, px, at least 1.</param>
    /// <param name="spacingH">From column to column, px, at least 1.</param>
    /// <param name="spacingV">From row to row, px, at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A size or a spacing is below 1.</exception>
    public PixelGrid(int width, int height, int spacingH, int spacingV)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(spacingH, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(spacingV, 1);
        SpacingH = spacingH;
        SpacingV = spacingV;
        Columns = width / spacingH;
        Rows = height / spacingV;
    }

    /// <summary>From column to column, px.</summary>
    public int SpacingH { get; }

    /// <summary>From row to row, px.</summary>
    public int SpacingV { get; }

    /// <summary>How many columns the grid has; 0 if the spacing is larger than the image.</summary>
    public int Columns { get; }

    /// <summary>How many rows the grid has; 0 if the spacing is larger than the image.</summary>
    public int Rows { get; }

    /// <summary>The pixel's x of a column, from 1.</summary>
    /// <param name="column">0 to <see cref="Columns"/> - 1.</param>
    public int PixelX(int column) => (column + 1) * SpacingH;

    /// <summary>The pixel's y of a row, from 1, down.</summary>
    /// <param name="row">0 to <see cref="Rows"/> - 1.</param>
    public int PixelY(int row) => (row + 1) * SpacingV;
}
