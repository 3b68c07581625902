using Msisf.Adapters.CameraExport;
using Msisf.Adapters.IO;
using Msisf.Adapters.Layers;
using Msisf.Adapters.Maps;
using Msisf.Adapters.Metadata;
using Msisf.Adapters.Navigation;
using Msisf.Adapters.Render;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Sensitivity;

namespace Msisf.App.Products;

/// <summary>All that can be written of an image. The order is that in which the files are named; the first one appears last.</summary>
internal static class ProductTable
{
    public static IReadOnlyList<Product> All { get; } =
    [
        new("image", [File("the image", [], ".png")], _ => true, FrameProducts.Image)
        {
            DiskBytes = settings => ProductSizes.PixelsOf(settings)
                * (ProductSizes.PngOf(settings) + (settings.Native.Detector is null ? 0.0 : ProductSizes.NumberBytes)),
        },
        new(
            "annotated", [File("the meta file drawn on the image", [OutputOptions.Annotation], ".annotated.png")],
            settings => settings.Annotate, FrameProducts.Annotated)
        {
            DiskBytes = settings => ProductSizes.PngOf(settings) * ProductSizes.PixelsOf(settings),
            MemoryBytesPerPixel = ProductSizes.AnnotationMemory,
            NeedsWhole = _ => OutputOptions.Annotation.Name,
        },
        new(
            "scene", [File("the scene that POV-Ray rendered", [], ".pov")], settings => settings.Renderer == RendererKind.PovRay,
            (frame, put) => put.Text("pov", frame.Rendered.WriteScene!)),
        new("meta", [File("the meta file, described below", [], ".xml")], _ => true, FrameProducts.Meta)
        {
            Phase = Phase.Xml,
            DiskBytes = ProductSizes.MetaBytes,
        },
        new(
            "numbers",
            [
                File(
                    "with a camera that has a detector: its digital numbers ([detector.md](detector.md)); the image has them too", [],
                    ".dn.fits"),
            ],
            settings => settings.Native.Detector is { WritesFits: true }, FrameProducts.Numbers)
        {
            PlaceInAnswer = 2,
            CanBeAnswer = true,
            DiskBytes = settings => ProductSizes.NumberBytes * ProductSizes.PixelsOf(settings),
            Require = (_, _) => FitsLayerWriter.RequireCFitsio(),
        },
        new(
            "camera-model",
            [
                File(
                    "[the camera for other programs](camera-export.md)", [CameraModelOptions.OfRun],
                    [.. CameraFormat.All.SelectMany(format => format.Endings)]) with
                {
                    Shown = "`.csm.json`, `.tsai`, `.opencv.yaml` ...",
                },
            ],
            settings => settings.CameraFormats.Count > 0, FrameProducts.CameraModels)
        {
            DiskBytes = settings => ProductSizes.PixelsOf(settings)
                * ProductSizes.CubeBytes * settings.CameraFormats.Count(format => format.HasPixels),
            NeedsWhole = settings => settings.CameraFormats.FirstOrDefault(format => format.HasPixels) is { } model
                ? $"{CameraModelOptions.OfRun.Name} {model.Word}"
                : null,
            IsMadeLater = true,
            PlaceInAnswer = 3,
            ContentType = "text/plain",
        },
        new(
            "craters",
            [
                File(
                    "the craters of the image, as CSV and in COCO's format ([navigation-truth.md](navigation-truth.md#craters)); the meta "
                        + "file has them too", [NavigationOptions.Craters], ".craters.csv", ".craters.json"),
            ],
            settings => settings.Native.Navigation?.Craters is not null, FrameProducts.Craters)
        {
            Phase = Phase.Navigation,
            NeedsWhole = _ => NavigationOptions.Craters.Name,
        },
        new(
            "landmarks",
            [File("[where the image shows them](navigation-truth.md#landmarks)", [NavigationOptions.Landmarks], ".landmarks.csv")],
            settings => settings.Native.Navigation?.Landmarks is not null, FrameProducts.Landmarks)
        {
            Phase = Phase.Navigation,
            NeedsWhole = _ => NavigationOptions.Landmarks.Name,
        },
        new(
            "stars", [File("[what the image shows of them](sky.md#where-it-is-written)", [SkyOptions.Stars], ".stars.csv")],
            settings => settings.Native.Sky?.Catalogue is not null,
            (frame, put) => put.Text("stars.csv", writer => SkyCsvWriter.Write(writer, frame.Metadata.Stars!)))
        {
            Phase = Phase.Sky,
            NeedsWhole = _ => SkyOptions.Stars.Name,
        },
        new(
            "bodies",
            [
                File(
                    "the same of these", [SkyOptions.Planets, SkyOptions.Earth, SkyOptions.SunInView], ".bodies.csv"),
            ],
            settings => settings.Native.Sky is { Bodies.Count: > 0 },
            (frame, put) => put.Text("bodies.csv", writer => SkyCsvWriter.Write(writer, frame.Metadata.Bodies!)))
        {
            Phase = Phase.Sky,
            NeedsWhole = _ => "the sky",
        },
        new(
            "flow",
            [
                File(
                    "[where the pixels lie in another image](navigation-truth.md#flow-and-stereo)", [NavigationOptions.Flow],
                    ".flow.fits", ".flow.npy", ".flow-class.npy", ".flow-light.npy", ".flow.json", ".flow.flo", ".flow.png") with
                {
                    Shown = "`.flow.*`",
                },
            ],
            settings => settings.Native.Navigation?.Flow is not null, FlowProduct.WriteFlow)
        {
            Phase = Phase.Navigation,
            NeedsWhole = _ => NavigationOptions.Flow.Name,
            Require = RequireForFlow,
        },
        new(
            "stereo",
            [
                File(
                    "the same of the image of a camera beside this one", [NavigationOptions.Stereo],
                    ".stereo.fits", ".disparity.npy", ".disparity-class.npy", ".stereo.json", ".disparity.png") with
                {
                    Shown = "`.disparity.*`, `.stereo.*`",
                },
            ],
            settings => settings.Native.Navigation?.Stereo is not null, FlowProduct.WriteStereo)
        {
            Phase = Phase.Navigation,
            NeedsWhole = _ => NavigationOptions.Stereo.Name,
            Require = RequireForFlow,
        },
        new(
            "sensitivity",
            [
                File(
                    "[derivatives of each pixel](sensitivities.md#layers), stored like the layers", [NavigationOptions.Sensitivity],
                    [
                        .. LayerFormat.EndingsOf([.. Parameter.All.Select(SensitivityLayers.NameOf)])
                            .Select(ending => $".sensitivity{ending}"),
                    ]) with
                {
                    Shown = "`.sensitivity.fits`, or `.sensitivity.d-NAME.npy` with `.sensitivity.layers.json`",
                },
                File(
                    "[what the image tells of its pose](sensitivities.md#information)", [NavigationOptions.Information],
                    ".information.csv"),
            ],
            settings => settings.Native.Navigation is { Sensitivity: not null } or { Information: not null }, SensitivityProduct.Write)
        {
            Phase = Phase.Navigation,
            PlaceInAnswer = 5,
            DiskBytes = settings => ProductSizes.LayerBytes(settings, settings.Native.Navigation!.Sensitivity?.Count ?? 0),
            NeedsWhole = _ => NavigationOptions.Sensitivity.Name,
            Require = (settings, _) =>
            {
                if (settings.Native.Navigation!.Sensitivity is not null)
                {
                    settings.Native.LayersFormat.Require();
                }
            },
        },
        new(
            "certain",
            [
                File(
                    "[bounds of each pixel](sensitivities.md#certain-pixels), stored like layers", [NavigationOptions.Certify],
                    [.. LayerFormat.EndingsOf(CertainLayers.Names).Select(ending => $".certain{ending}")]) with
                {
                    Shown = "`.certain.fits`, or `.certain.NAME.npy` with `.certain.layers.json`",
                },
            ],
            settings => settings.Native.Navigation?.Limits is not null, SensitivityProduct.WriteCertain)
        {
            Phase = Phase.Navigation,
            PlaceInAnswer = 6,
            DiskBytes = settings => ProductSizes.LayerBytes(settings, CertainLayers.Names.Count),
            NeedsWhole = _ => NavigationOptions.Certify.Name,
            Require = (settings, _) => settings.Native.LayersFormat.Require(),
        },
        new(
            "map",
            [
                File("[image and layers on a map](#images-on-a-map)", [MapOptions.Map], [.. ImageMapFiles.Endings]) with
                {
                    Shown = "`.map.tif`, `.LAYER.map.tif`",
                },
            ],
            settings => settings.Map is not null, MapProduct.Write)
        {
            Phase = Phase.Layers,
            PlaceInAnswer = 4,
            NeedsWhole = _ => MapOptions.Map.Name,
            Require = (_, gdalPath) => ImageMapFiles.RequireGdal(gdalPath),
        },
        new(
            "layers",
            [
                File(
                    "the ground truth of each pixel, described at the end, as `--layers-format` says", [NativeOptions.Layers],
                    [.. LayerFormat.EndingsOf([.. LayerCatalogue.All.Select(layer => layer.Name)])]) with
                {
                    Shown = string.Join(", ", LayerFormat.EndingsOf(["LAYER"]).Select(ending => $"`{ending}`")),
                },
            ],
            settings => settings.Native.Layers is not null, FrameProducts.Layers)
        {
            Phase = Phase.Layers,
            PlaceInAnswer = 1,
            CanBeAnswer = true,
            DiskBytes = ProductSizes.LayerBytes,
            MemoryBytesPerPixel = ProductSizes.LayerMemory,
            Require = (settings, _) => settings.Native.LayersFormat.Require(),
        },
    ];

    /// <summary>The product of a name.</summary>
    public static Product Named(string name) => All.Single(product => product.Name == name);

    /// <summary>Those that settings ask for.</summary>
    public static IEnumerable<Product> Of(RenderSettings settings) => All.Where(product => product.IsWanted(settings));

    private static readonly string[] Endings = [.. All.SelectMany(product => product.Files).SelectMany(file => file.Endings)];

    /// <summary>All names that files of a frame can have, whatever a run was asked to write.</summary>
    public static IEnumerable<string> NamesOf(string frame) => Endings.Select(ending => frame + ending);

    /// <summary>The names of the frames that a file could belong to by its name.</summary>
    /// <param name="file">Name of the file, without folder.</param>
    public static IEnumerable<string> FramesOf(string file) => Endings
        .Where(ending => file.EndsWith(ending, StringComparison.Ordinal))
        .Select(ending => file[..^ending.Length]);

    /// <summary>Whether a file may be made of a frame that is there, by msis camera-model, so that no record names it.</summary>
    /// <param name="file">Name of the file, without folder.</param>
    public static bool IsMadeLater(string file) => All
        .Where(product => product.IsMadeLater)
        .SelectMany(product => product.Files)
        .SelectMany(written => written.Endings)
        .Any(ending => file.EndsWith(ending, StringComparison.Ordinal));

    /// <summary>Refuses products that need all of an image that is drawn in strips.</summary>
    /// <exception cref="UsageException">An option asks for one.</exception>
    public static void RefuseInStrips(RenderSettings settings)
    {
        if (!StripRules.IsStriped(settings.Scan, settings.Width, settings.Height))
        {
            return;
        }

        string? wrong = Of(settings).Select(product => product.NeedsWhole(settings)).FirstOrDefault(reason => reason is not null)
            ?? (settings.Native.FindsExposureTime ? $"{NativeOptions.ExposureTime.Name} {NativeOptions.Automatic}" : null);
        if (wrong is not null)
        {
            throw new UsageException(
                $"an image of {settings.Width} x {settings.Height} px is drawn in strips, and {wrong} needs more of it at once. Leave it "
                    + $"out, or scan fewer lines: {StripRules.LargestWhole / settings.Width} are drawn as a whole.");
        }
    }

    private static ProductFile File(string content, OptionSpec[] options, params string[] endings) => new(endings, options, content);

    private static void RequireForFlow(RenderSettings settings, string? gdalPath)
    {
        if (settings.Native.Navigation!.FlowFormats.HasFlag(FlowFormats.Fits))
        {
            FitsLayerWriter.RequireCFitsio();
        }
    }
}
