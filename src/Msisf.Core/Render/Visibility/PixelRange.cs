namespace Msisf.Core.Render.Visibility;

/// <summary>A rectangle of pixels, counted from 0, with both ends included. It is empty if a first index is above its last.</summary>
internal readonly record struct PixelRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    public bool IsEmpty => FirstColumn > LastColumn || FirstRow > LastRow;

    /// <summary>The pixels of a band that are drawn and whose centres lie within limits (px), which may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, Band band) => new(
        (int)Math.Clamp(Math.Ceiling(left), band.Window.FirstColumn, band.Window.LastColumn + 1.0),
        (int)Math.Clamp(Math.Floor(right), band.Window.FirstColumn - 1.0, band.Window.LastColumn),
        (int)Math.Clamp(Math.Ceiling(top), band.Window.FirstRow, band.Window.LastRow + 1.0),
        (int)Math.Clamp(Math.Floor(bottom), band.Window.FirstRow - 1.0, band.Window.LastRow));
}
