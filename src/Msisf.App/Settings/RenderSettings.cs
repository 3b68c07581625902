using Msisf.Adapters.Camera;
using Msisf.Adapters.CameraExport;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>The checked options of a render run, except for the camera.</summary>
internal sealed record RenderSettings
{
    /// <summary>The camera file; null for the thesis's camera.</summary>
    public CameraFile? Camera { get; init; }

    /// <summary>Which camera of a rig it is; null for a run with one camera.</summary>
    public RigCamera? Rig { get; init; }

    public InputFile? RigFile { get; init; }

    public required double FieldOfViewDegrees { get; init; }

    public required int Width { get; init; }

    public required int Height { get; init; }

    /// <summary>How an image is scanned; null for a frame.</summary>
    public Scan? Scan { get; init; }

    /// <summary>s: the time between exposures as the user gives it; null for that of the camera file.</summary>
    public double? GivenScanPeriod { get; init; }

    /// <summary>Small turns of the camera; null for none.</summary>
    public JitterFile? Jitter { get; init; }

    /// <summary>The geometry of the camera file, or of the thesis's camera.</summary>
    public CameraModel CameraModel => Camera?.Model
        ?? CameraModel.FromFieldOfView(FieldOfViewDegrees * Math.PI / 180.0, Width, Height);

    public required int GridHorizontal { get; init; }

    public required int GridVertical { get; init; }

    public required PixelSurface Surface { get; init; }

    /// <summary>Resolution of the elevation model: that of --res, or of the polar map that --ldem names.</summary>
    public required GridResolution Resolution { get; init; }

    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    public required RendererKind Renderer { get; init; }

    /// <summary>Settings of the program's own renderer; defaults if POV-Ray is used.</summary>
    public required NativeSettings Native { get; init; }

    /// <summary>The shutter of the camera's detector; null for images without the camera's motion.</summary>
    public Shutter? Shutter => Native.Detector?.Settings.Shutter;

    /// <summary>s: how long the shutter is open for any row; 0 without a shutter, or before that is found.</summary>
    public double ShutterSpan =>
        Native.FindsExposureTime ? 0.0 : Shutter?.Span(Native.Detector!.Settings.ExposureTime, CameraModel.Height) ?? 0.0;

    /// <summary>s: how long before and after the middle of an exposure the state must be known.</summary>
    public double ExposureReach => (0.5 * ShutterSpan) + (Scan is { } scan ? 0.5 * (scan.Stages - 1) * scan.Period : 0.0);

    public required AlbedoSettings Albedo { get; init; }

    /// <summary>px: how far coarser levels of the model may shift a point in the image; null to use the full model everywhere.</summary>
    public required double? LevelOfDetailError { get; init; }

    /// <summary>
    /// Samples along a pixel's edge for which levels of detail are chosen; POV-Ray's antialiasing takes more than one only where
    /// neighbours differ.
    /// </summary>
    public int DetailSubsamplesPerAxis => Renderer == RendererKind.Native ? Native.Render.DetailSubsamplesPerAxis : 1;

    public required bool IgnoreSun { get; init; }

    public required bool Annotate { get; init; }

    /// <summary>Forms in which each frame's camera is written for other programs.</summary>
    public IReadOnlyList<CameraFormat> CameraFormats { get; init; } = [];

    /// <summary>The map onto which images are put; null for none.</summary>
    public MapSettings? Map { get; init; }

    public required string OutputFolder { get; init; }

    public required string OutputName { get; init; }

    public required string PatternRepository { get; init; }

    /// <summary>Paths of the elevation models; empty for the one that is found for the resolution.</summary>
    public required IReadOnlyList<string> Ldem { get; init; }

    public required EphemerisChoice Ephemeris { get; init; }

    public required Aberration Aberration { get; init; }

    /// <summary>Meta-kernels and kernels of --kernels, in their order.</summary>
    public required IReadOnlyList<string> Kernels { get; init; }

    /// <summary>Kernels of the camera's trajectory, in their order; they are loaded last.</summary>
    public SpacecraftKernels SpacecraftKernels { get; init; } = SpacecraftKernels.None;

    /// <summary>Whether kernels are needed: for the Sun, for the trajectory, or for camera models.</summary>
    public bool NeedsKernels => !IgnoreSun || IsMission || Native.Sky is not null || CameraFormats.Any(format => format.NeedsEphemeris);

    /// <summary>Whether the files of a mission say where the camera is.</summary>
    public bool IsMission { get; init; }

    public required string? PovPath { get; init; }

    public required IReadOnlyList<string> PovOptions { get; init; }

    public required TimeSpan? Timeout { get; init; }

    public required int? Jobs { get; init; }

    public required StepRanges? Frames { get; init; }

    /// <summary>The steps to make of a run.</summary>
    /// <param name="count">How many the run has.</param>
    /// <exception cref="UsageException">One of them is not part of the run.</exception>
    public IEnumerable<int> StepsOf(int count) => Frames switch
    {
        null => Enumerable.Range(1, count),
        { } chosen when chosen.Last > count => throw new UsageException(Invariant(
            $"--frames {chosen}: step {chosen.Last} is wanted, but the run has {count} only. Name steps that it has.")),
        { } chosen => chosen.Steps,
    };

    public required bool Overwrite { get; init; }

    public required bool FailFast { get; init; }

    /// <summary>Path of the file for the times of single frames; null for none.</summary>
    public required string? FrameTimes { get; init; }

    public required bool Unattended { get; init; }

    public required bool ListPatterns { get; init; }

    public required bool Timing { get; init; }
}
