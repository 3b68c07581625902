namespace Msisf.Core.Render.Visibility;

/// <summary>A rectangle of pixels, counted from 0, with both ends included. It is empty if a first index is above its last.</summary>
internal readonly record struct PixelRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    public bool IsEmpty => FirstColumn > LastColumn || FirstRow > LastRow;

    /// <summary>The pixels of a band that are drawn and whose centres lie within limits (px), which may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, Band band) =>
        Within(left, right, top, bottom, band.Window);

    /// <summary>The pixels of a window whose centres lie within limits (px), which may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, in PixelRange window) => new(
        (int)Math.Clamp(Math.Ceiling(left), window.FirstColumn, window.LastColumn + 1.0),
        (int)Math.Clamp(Math.Floor(right), window.FirstColumn - 1.0, window.LastColumn),
        (int)Math.Clamp(Math.Ceiling(top), window.FirstRow, window.LastRow + 1.0),
        (int)Math.Clamp(Math.Floor(bottom), window.FirstRow - 1.0, window.LastRow));
}
