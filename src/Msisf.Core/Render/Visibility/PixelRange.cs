namespace Msisf.Core.Render.Visibility;

/// <summary>A rectangle of pixels, counted from 0, with both ends included. It is empty if a first index is above its last.</summary>
internal readonly record struct PixelRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    public bool IsEmpty => FirstColumn > LastColumn || FirstRow > LastRow;

    /// <summary>The pixels of a band whose centres lie within limits (px), which may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, Band band) => new(
        (int)Math.Clamp(Math.Ceiling(left), 0.0, band.Width),
        (int)Math.Clamp(Math.Floor(right), -1.0, band.Width - 1.0),
        (int)Math.Clamp(Math.Ceiling(top), band.FirstRow, band.LastRow + 1.0),
        (int)Math.Clamp(Math.Floor(bottom), band.FirstRow - 1.0, band.LastRow));
}
