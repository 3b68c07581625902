namespace Msisf.App.Serving;

/// <summary>Where a point of the surface is seen in an image.</summary>
/// <param name="X">Pixels from 1, to the right; null if the point lies behind the camera.</param>
/// <param name="Y">Pixels from 1, down.</param>
/// <param name="Visible">Whether the image shows the point.</param>
/// <param name="HiddenBy">"limb", "terrain" or "outside the image"; null for a visible point.</param>
/// <param name="Lit">Whether light from the Sun's centre, or the lamp, reaches the point.</param>
internal sealed record PixelReading(double? X, double? Y, bool Visible, string? HiddenBy, bool Lit);
