using Msisf.Adapters.Camera;
using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The checked options of the program's own renderer.</summary>
internal sealed record NativeSettings
{
    public required NativeRenderOptions Render { get; init; }

    /// <summary>The reflectance law as text: its name and the given parameters in the order of their names.</summary>
    public required string ReflectanceText { get; init; }

    /// <summary>Path of the map of Hapke's parameters; null for none.</summary>
    public required string? HapkeMap { get; init; }

    /// <summary>Given albedo; null for the default of the law.</summary>
    public required double? Albedo { get; init; }

    public required GreyScale Grey { get; init; }

    public required int BitDepth { get; init; }

    /// <summary>The camera's optics and detector; null for an image of grey levels.</summary>
    public CameraFileDetector? Detector { get; init; }

    /// <summary>s: the exposure time that the user gave, or that was found for the run; null for that of the camera file.</summary>
    public double? ExposureTime { get; private init; }

    /// <summary>Whether the exposure time is still to be found.</summary>
    public bool FindsExposureTime { get; init; }

    /// <summary>Whether the exposure of the grey levels is still to be found; <see cref="Grey"/> has that of the law.</summary>
    public bool FindsExposure { get; init; }

    /// <summary>Invented detail below the elevation models; null for none.</summary>
    public RefineSettings? Refine { get; init; }

    public NavigationSettings? Navigation { get; init; }

    /// <summary>The sky behind the ground; null for none.</summary>
    public SkySettings? Sky { get; init; }

    /// <summary>Layers of ground truth to write; null for none.</summary>
    public required LayerSet? Layers { get; init; }

    public required LayerFormat LayersFormat { get; init; }

    public required LayerPrecision LayersPrecision { get; init; }

    public required LayerCompression LayersCompression { get; init; }

    /// <summary>These settings with another exposure of the grey levels.</summary>
    /// <param name="exposure">Linear grey of I/F = 1.</param>
    public NativeSettings WithExposure(double exposure)
    {
        GreyScale grey = new(exposure, Grey.Transfer);
        return this with
        {
            Grey = grey,
            FindsExposure = false,
            Render = Render.Adaptive is { } sampling ? Render with { Adaptive = new AdaptiveSampling(sampling.Error, grey) } : Render,
        };
    }

    /// <summary>These settings with another exposure time than the camera file's.</summary>
    /// <param name="seconds">s, above 0.</param>
    public NativeSettings WithExposureTime(double seconds) => this with
    {
        ExposureTime = seconds,
        FindsExposureTime = false,
        Detector = Detector! with { Settings = Detector.Settings with { ExposureTime = seconds } },
    };
}
