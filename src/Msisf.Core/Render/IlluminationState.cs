namespace Msisf.Core.Render;

/// <summary>How a point of the surface is lit; the numbers are those of the mask layer (docs/formats.md).</summary>
public enum IlluminationState : byte
{
    /// <summary>The pixel shows no surface.</summary>
    NoSurface = 0,

    /// <summary>The whole Sun, or the point light that replaces it, is visible from the point.</summary>
    Lit = 1,

    /// <summary>A part of the Sun's disc is visible from the point.</summary>
    Penumbra = 2,

    /// <summary>
    /// The Sun's centre is above the point's horizontal plane, but the point's facet faces away from the Sun or other terrain hides it.
    /// </summary>
    Shadow = 3,

    /// <summary>No part of the Sun is visible from the point, and the Sun's centre is below the point's horizontal plane.</summary>
    Night = 4,
}
