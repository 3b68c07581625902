namespace Msisf.Core.Render.Visibility;

/// <summary>A rectangle of pixels, counted from 0, both ends included; empty if a first one lies behind its last.</summary>
internal readonly record struct PixelRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    public bool IsEmpty => FirstColumn > LastColumn || FirstRow > LastRow;

    /// <summary>The pixels of a band whose centres lie within limits; these may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, Band band) => new(
        (int)Math.Clamp(Math.Ceiling(left), 0.0, band.Width),
        (int)Math.Clamp(Math.Floor(right), -1.0, band.Width - 1.0),
        (int)Math.Clamp(Math.Ceiling(top), band.FirstRow, band.LastRow + 1.0),
        (int)Math.Clamp(Math.Floor(bottom), band.FirstRow - 1.0, band.LastRow));
}
