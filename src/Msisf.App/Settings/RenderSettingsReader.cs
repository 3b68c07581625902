using Msisf.Adapters.Camera;
using Msisf.Adapters.CameraExport;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Render;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Lod;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Reads the options of a run, except for the camera.</summary>
internal static class RenderSettingsReader
{
    /// <summary>Reads and checks all options.</summary>
    /// <param name="openCamera">Opens the camera of a name; null for a preset or a file.</param>
    /// <param name="geoTiffs">Opens elevation models in GeoTIFF, to be used again for the run; null if the run is not made here.</param>
    /// <param name="known">Resolution of the model, so that its files need not be asked; null if it is not known.</param>
    /// <exception cref="MsisfException">A value is wrong, or an option can't be combined with another.</exception>
    public static RenderSettings Read(
        OptionValues values, Func<string, CameraFile>? openCamera = null, GeoTiffFiles? geoTiffs = null, GridResolution? known = null)
    {
        PixelSurface surface = OutputOptions.Surface.Read(values);
        int grid = OutputOptions.Grid.Read(values);
        RendererKind renderer = RendererOptions.Renderer.Read(values);
        RendererOptions.Check(values);
        AlbedoSettings albedo = AlbedoOptions.Read(values);
        CameraFile? camera = CameraChoice.Read(values, openCamera);
        Scan? scan = ScanOptions.Read(camera, values);
        if (scan is not null && renderer == RendererKind.PovRay)
        {
            throw new UsageException(
                "the rows of a camera that scans have times and places of their own, which POV-Ray can't draw. Add --renderer native.")
                .About(ImageOptions.Camera, RendererOptions.Renderer);
        }

        IReadOnlyList<CameraFormat> cameraFormats = CameraModelOptions.ReadOfRun(values, renderer);
        MapSettings? map = MapOptions.Read(values, renderer);
        bool needsTruth = surface == PixelSurface.Terrain || map is not null || cameraFormats.Any(format => format.HasPixels);
        BodyChoice.CheckModel(values);
        GridResolution resolution = known ?? ModelChoice.ResolutionOf(values, geoTiffs);
        RenderSettings settings = new()
        {
            Camera = camera,
            FieldOfViewDegrees = camera?.FieldOfViewDegrees ?? ImageOptions.FieldOfView.Read(values),
            Width = camera?.Model.Width ?? ImageOptions.Width.Read(values),
            Height = scan?.HeightOf(camera!.Model) ?? camera?.Model.Height ?? ImageOptions.Height.Read(values),
            Scan = scan,
            GivenScanPeriod = ScanOptions.Period.ReadIfGiven(values),
            Jitter = ScanOptions.ReadJitter(values),
            GridHorizontal = OutputOptions.GridHorizontal.ReadIfGiven(values) ?? grid,
            GridVertical = OutputOptions.GridVertical.ReadIfGiven(values) ?? grid,
            Surface = surface,
            Resolution = resolution,
            Body = BodyChoice.Read(values, renderer, resolution),
            Renderer = renderer,
            Native = NativeSettingsReader.Read(
                values, albedo, DetectorChoice.Of(camera, values), scans: scan is not null, needsTruth),
            Albedo = albedo,
            LevelOfDetailError = LevelOfDetailError(values),
            IgnoreSun = LightOptions.IgnoreSun.Read(values),
            CameraFormats = cameraFormats,
            Map = map,
            Annotate = OutputOptions.Annotation.Read(values),
            OutputFolder = OutputOptions.Folder.Read(values),
            OutputName = OutputOptions.Name.Read(values),
            PatternRepository = PovOptions.PatternRepository.Read(values),
            Ldem = SurfaceOptions.Ldem.ReadAll(values),
            Ephemeris = LightOptions.Ephemeris.Read(values),
            Aberration = Aberration(values),
            Kernels = LightOptions.Kernels.ReadAll(values),
            SpacecraftKernels = MissionOptions.ReadKernels(values),
            IsMission = TrajectorySettingsReader.IsMission(values),
            PovPath = PovOptions.Program.ReadIfGiven(values),
            PovOptions = PovOptions.MoreOptions.NamedInErrors(
                () => PovRayOptions.Parse(PovOptions.MoreOptions.ReadIfGiven(values) ?? string.Empty)),
            Timeout = PovOptions.Timeout.ReadIfGiven(values) is { } seconds ? TimeSpan.FromSeconds(seconds) : null,
            Jobs = RunOptions.Jobs.ReadIfGiven(values),
            Frames = RunOptions.Frames.ReadIfGiven(values) is { } steps ? RunOptions.Frames.Named(() => StepRanges.Parse(steps)) : null,
            Overwrite = RunOptions.Overwrite.Read(values),
            FailFast = RunOptions.FailFast.Read(values),
            FrameTimes = RunOptions.FrameTimes.ReadIfGiven(values),
            Unattended = RunOptions.Batch.Read(values),
            ListPatterns = PovOptions.ListPatterns.Read(values),
            Timing = RunOptions.Timing.Read(values),
        };
        CameraModelOptions.Require(settings);
        return settings;
    }

    private static double? LevelOfDetailError(OptionValues values)
    {
        bool isOff = SurfaceOptions.LevelOfDetail.Read(values);
        double? given = SurfaceOptions.LevelOfDetailError.ReadIfGiven(values);
        if (isOff)
        {
            return given is null
                ? null
                : throw SurfaceOptions.LevelOfDetailError.Wrong(
                    "has no meaning with --lod off, which always shows the model itself. Leave one of them out.",
                    SurfaceOptions.LevelOfDetail);
        }

        return given ?? DetailRule.DefaultError;
    }

    private static Aberration Aberration(OptionValues values)
    {
        Aberration aberration = LightOptions.Aberration.Read(values);
        return values.Text(LightOptions.Aberration) is not null && LightOptions.IgnoreSun.Read(values)
            ? throw LightOptions.Aberration.Wrong(
                "has no meaning with --ignore-sun, which lights the scene from the camera. Leave one out.", LightOptions.IgnoreSun)
            : aberration;
    }
}
