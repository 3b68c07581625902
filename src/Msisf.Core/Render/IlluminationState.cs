namespace Msisf.Core.Render;

/// <summary>How a point of the surface is lit; the numbers are those of the mask layer (docs/formats.md).</summary>
public enum IlluminationState : byte
{
    /// <summary>The pixel shows no surface.</summary>
    NoSurface = 0,

    /// <summary>The whole Sun, or the point that stands for it, shines on the point.</summary>
    Lit = 1,

    /// <summary>A part of the Sun's disc shines on it.</summary>
    Penumbra = 2,

    /// <summary>
    /// The Sun's centre is above the point's horizontal plane, but its facet turns away from it or other terrain hides it.
    /// </summary>
    Shadow = 3,

    /// <summary>No part of the Sun shines on the point, and its centre is below the point's horizontal plane.</summary>
    Night = 4,
}
