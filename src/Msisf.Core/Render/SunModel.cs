namespace Msisf.Core.Render;

/// <summary>How the renderer models the Sun.</summary>
public enum SunModel
{
    /// <summary>A point at the Sun's centre: shadows have sharp borders, as in POV-Ray's scene.</summary>
    Point,

    /// <summary>A disc of the Sun's true angular size: shadows have penumbras.</summary>
    Disc,
}
