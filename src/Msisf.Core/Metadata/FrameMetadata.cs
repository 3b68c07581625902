using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Navigation;
using Msisf.Core.Render;
using Msisf.Core.Sky;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.Core.Metadata;

/// <summary>Metadata of a whole frame: the file's GeneralInformation (thesis section 9.2). Immutable.</summary>
/// <param name="SimulationTime">UTC.</param>
/// <param name="Camera">Position and orientation.</param>
/// <param name="FieldOfViewDegrees">Horizontal field of view as the user gave it.</param>
/// <param name="SunPositionBodyFixed">m; with <c>--ignore-sun</c> the position of the light, which is the camera's.</param>
/// <param name="Elevation">The elevation model.</param>
/// <param name="HeightOverTerrain">Height of the camera over the model's surface below it, m.</param>
/// <param name="Version">Version of the program.</param>
/// <param name="CommandLine">The arguments of the call.</param>
/// <param name="Renderer">The renderer that made the image.</param>
/// <param name="Inputs">The files that the frame was made from.</param>
public sealed record FrameMetadata(
    Instant SimulationTime,
    ICamera Camera,
    double FieldOfViewDegrees,
    Vector3D SunPositionBodyFixed,
    DrawnElevation Elevation,
    double HeightOverTerrain,
    string Version,
    string CommandLine,
    RendererKind Renderer,
    IReadOnlyList<InputFile> Inputs)
{
    /// <summary>The body that the frame shows; positions and directions are in its frame.</summary>
    public DrawnGlobe Globe { get; init; } = DrawnGlobe.Moon;

    /// <summary>Which kernels give the body's frame; null where they are those of the installation.</summary>
    public string? Orientation { get; init; }

    /// <summary>How the image was scanned; null for a frame.</summary>
    public Scan? Scan { get; init; }

    /// <summary>Which camera of a rig took the image; null without a rig.</summary>
    public RigCamera? Rig { get; init; }

    /// <summary>Craters of the frame; null without such truth.</summary>
    public NavigationTruth? Navigation { get; init; }

    /// <summary>Stars of the frame; null where none are drawn.</summary>
    public StarsOfFrame? Stars { get; init; }

    /// <summary>Planets, the Earth and the Sun behind the frame's ground; null where none are drawn.</summary>
    public BodiesOfFrame? Bodies { get; init; }

    /// <summary>m: height of the camera over the Moon's mean radius (thesis section 9.2), or over another body's sphere.</summary>
    public double FlightAltitude => Camera.PositionBodyFixed.Length - Globe.AltitudeRadius;

    /// <summary>Name of the renderer, as the command line and the files have it.</summary>
    public string RendererName => Renderer switch
    {
        RendererKind.PovRay => "povray",
        RendererKind.Native => "native",
        _ => throw new InvalidOperationException($"{Renderer} is not a renderer."),
    };
}

/// <summary>A file that a frame was made from: another content of it could give other outputs.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Name">Its name without folders, so that a frame is the same wherever its inputs lie.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="Sha256">SHA-256 of its content: 64 hexadecimal digits in small letters.</param>
public sealed record InputFile(InputKind Kind, string Name, long Bytes, string Sha256)
{
    /// <summary>
    /// Whether the SHA-256 is that of the file's length and of pieces spread over it, because to read all of it takes minutes.
    /// </summary>
    public bool IsOfPieces { get; init; }

    /// <summary>Name and checksum in one text.</summary>
    public string Text => $"{Name} {(IsOfPieces ? "sha256OfPieces" : "sha256")}:{Sha256}";
}

/// <summary>The body that a frame shows, and the sphere over which its heights are counted.</summary>
/// <param name="ReferenceRadius">m.</param>
public sealed record DrawnGlobe(CelestialBody Body, double ReferenceRadius)
{
    /// <summary>The Moon on LOLA's sphere.</summary>
    public static DrawnGlobe Moon { get; } = new(CelestialBody.Moon, MoonConstants.ReferenceRadius);

    /// <summary>Radius from which the camera's altitude counts, m: the thesis's mean radius of the Moon, or the reference.</summary>
    public double AltitudeRadius => Body.IsMoon ? MoonConstants.MeanRadius : ReferenceRadius;

    /// <summary>A text that describes something of the Moon, for this body: with its name, frame and sphere.</summary>
    public string Describe(string textOfMoon) => Body.IsMoon
        ? textOfMoon
        : textOfMoon
            .Replace("MOON_ME (mean Earth/polar axis)", Body.Frame, StringComparison.Ordinal)
            .Replace("MOON_ME", Body.Frame, StringComparison.Ordinal)
            .Replace("the Moon", Body.Name, StringComparison.Ordinal)
            .Replace("1 737 400 m", Invariant($"{ReferenceRadius:R} m"), StringComparison.Ordinal);
}
