using System.Globalization;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Core.Metadata;

/// <summary>The body that a frame shows, and the sphere over which its heights are counted.</summary>
/// <param name="Body">The body.</param>
/// <param name="ReferenceRadius">m.</param>
public sealed record DrawnGlobe(CelestialBody Body, double ReferenceRadius)
{
    /// <summary>The Moon on LOLA's sphere.</summary>
    public static DrawnGlobe Moon { get; } = new(CelestialBody.Moon, MoonConstants.ReferenceRadius);

    /// <summary>m: the sphere over which the camera's altitude is counted: of the Moon the thesis's mean radius, else the reference.</summary>
    public double AltitudeRadius => Body.IsMoon ? MoonConstants.MeanRadius : ReferenceRadius;

    /// <summary>A text that describes something of the Moon, for this body: with its name, frame and sphere.</summary>
    public string Describe(string textOfMoon) => Body.IsMoon
        ? textOfMoon
        : textOfMoon
            .Replace("MOON_ME (mean Earth/polar axis)", Body.Frame, StringComparison.Ordinal)
            .Replace("MOON_ME", Body.Frame, StringComparison.Ordinal)
            .Replace("the Moon", Body.Name, StringComparison.Ordinal)
            .Replace("1 737 400 m", string.Create(CultureInfo.InvariantCulture, $"{ReferenceRadius:R} m"), StringComparison.Ordinal);
}
