namespace Msisf.Core.Render;

/// <summary>What the Sun is to the renderer.</summary>
public enum SunModel
{
    /// <summary>A point at the Sun's centre: shadows have sharp borders, as in POV-Ray's scene.</summary>
    Point,

    /// <summary>A disc of the Sun's true angular size: shadows have penumbras.</summary>
    Disc,
}
