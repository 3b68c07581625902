using Msisf.Core.Scene;

namespace Msisf.Core.Render;

/// <summary>The illumination of a pixel's surface point; <c>default</c> is a pixel without surface.</summary>
/// <param name="State">Lit, penumbra, shadow or night.</param>
/// <param name="VisibleFraction">Fraction of the Sun's disc that terrain does not hide, 0 to 1.</param>
public readonly record struct PixelIllumination(IlluminationState State, double VisibleFraction)
{
    /// <summary>The illumination of a surface point that a camera sees.</summary>
    /// <param name="pointBodyFixed">The surface point, m, body-fixed.</param>
    /// <param name="visibleFraction">
    /// Visible fraction of the Sun, 0 to 1; for a Sun that is a point it is 0 or 1. It is ignored for a lamp.
    /// </param>
    /// <param name="light">The Sun, or the lamp at the camera, which illuminates everything that the camera sees.</param>
    public static PixelIllumination At(Vector3D pointBodyFixed, double visibleFraction, SceneLight light)
    {
        if (!light.IsSun || visibleFraction >= 1.0)
        {
            return new PixelIllumination(IlluminationState.Lit, 1.0);
        }

        if (visibleFraction > 0.0)
        {
            return new PixelIllumination(IlluminationState.Penumbra, visibleFraction);
        }

        bool isAboveHorizon = Vector3D.Dot(pointBodyFixed, light.PositionBodyFixed - pointBodyFixed) > 0.0;
        return new PixelIllumination(isAboveHorizon ? IlluminationState.Shadow : IlluminationState.Night, 0.0);
    }
}

/// <summary>How files and answers name the states of illumination.</summary>
public static class IlluminationWords
{
    /// <summary>The word of a state that a point of the surface can have.</summary>
    public static string Word(this IlluminationState state) => state switch
    {
        IlluminationState.Lit => "lit",
        IlluminationState.Penumbra => "penumbra",
        IlluminationState.Shadow => "shadow",
        IlluminationState.Night => "night",
        _ => throw new ArgumentOutOfRangeException(nameof(state), state, "A terrain point is lit, in penumbra, in shadow or in the night."),
    };
}

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
