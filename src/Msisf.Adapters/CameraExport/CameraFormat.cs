using Msisf.Adapters.IO;
using Msisf.Adapters.States;
using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>A form in which a frame's camera is written for other programs (docs/camera-export.md). Immutable.</summary>
public sealed class CameraFormat
{
    private readonly Func<CameraModel, bool> _has;
    private readonly ExportedFile[] _files;

    private CameraFormat(string word, Func<CameraModel, bool> has, params ExportedFile[] files) =>
        (Word, _has, _files) = (word, has, files);

    /// <summary>All formats.</summary>
    public static IReadOnlyList<CameraFormat> All { get; } =
    [
        new("opencv", OpenCvCamera.Has, Text(".opencv.yaml", OpenCvCamera.Write)),
        new(
            "colmap", CameraTables.HasColmapModel,
            Text(".cameras.txt", (writer, frame) => CameraTables.WriteColmapCameras(writer, [frame.Camera.Model])),
            Text(".images.txt", (writer, frame) => CameraTables.WriteColmapImages(writer, [([frame.State], [frame.Name])])),
            Text(".points3D.txt", (writer, _) => CameraTables.WriteColmapPoints(writer))),
        new("tsai", TsaiCamera.Has, Text(".tsai", TsaiCamera.Write)),
        new("csm", CsmLens.Has, Text(".csm.json", CsmState.Write))
        {
            NeedsEphemeris = true,
            IsCsm = true,
            Scans = Enum.GetValues<ScanKind>(),
        },
        new("isd", CsmLens.Has, Text(".isd.json", (writer, frame) => AleIsd.Write(writer, frame, isInertial: true)))
        {
            NeedsEphemeris = true,
            IsCsm = true,
            Scans = Enum.GetValues<ScanKind>(),
        },
        new("isd-body", CsmLens.Has, Text(".isd-body.json", (writer, frame) => AleIsd.Write(writer, frame, isInertial: false)))
        {
            NeedsEphemeris = true,
            IsCsm = true,
            Scans = Enum.GetValues<ScanKind>(),
        },
        new("isis", IsisCube.Has, Bytes(".cub", IsisCube.Write)) { NeedsEphemeris = true, HasPixels = true, Scans = [ScanKind.LineScan] },
        new("pds4", _ => true, Bytes(Pds4Product.ArrayEnding, Pds4Product.WriteArray), Text(".lblx", Pds4Product.WriteLabel))
        {
            HasPixels = true,
            HasCamera = false,
            Scans = Enum.GetValues<ScanKind>(),
        },
    ];

    /// <summary>The word for it on the command line.</summary>
    public string Word { get; }

    /// <summary>Whether <see cref="ExportedFrame.Ephemeris"/> is needed.</summary>
    public bool NeedsEphemeris { get; private init; }

    /// <summary>Whether it holds the image too, so that <see cref="ExportedFrame.Image"/> is needed.</summary>
    public bool HasPixels { get; private init; }

    /// <summary>Whether USGSCSM reads it, which has cameras that scan.</summary>
    private bool IsCsm { get; init; }

    /// <summary>The cameras that scan which it has.</summary>
    private ScanKind[] Scans { get; init; } = [];

    /// <summary>Whether programs find a camera in it.</summary>
    private bool HasCamera { get; init; } = true;

    /// <summary>The endings of its files, which follow the frame's name.</summary>
    public IEnumerable<string> Endings => _files.Select(file => file.Ending);

    /// <summary>Reads a list of formats.</summary>
    /// <param name="text">Words, separated by commas.</param>
    /// <exception cref="BadInputException">A word is not a format.</exception>
    public static IReadOnlyList<CameraFormat> Parse(string text) =>
    [
        .. text.Split(',', StringSplitOptions.TrimEntries).Select(word =>
            All.FirstOrDefault(format => format.Word.Equals(word, StringComparison.OrdinalIgnoreCase))
                ?? throw new BadInputException(
                    $"'{word}' is not a format of camera models. Give some of {string.Join(", ", All.Select(f => f.Word))}."))
            .Distinct(),
    ];

    /// <summary>Refuses a camera that a format can't say.</summary>
    /// <param name="formats">The formats that are wanted.</param>
    /// <param name="camera">The camera, of a scan that of one exposure.</param>
    /// <param name="scan">How it scans; null for a frame.</param>
    /// <exception cref="BadInputException">Format, lens, and which formats can.</exception>
    public static void Require(IEnumerable<CameraFormat> formats, CameraModel camera, ScanKind? scan)
    {
        bool Has(CameraFormat format) => format._has(camera) && (scan is not { } kind || format.Scans.Contains(kind));
        if (formats.FirstOrDefault(format => !Has(format)) is not { } wrong)
        {
            return;
        }

        string Missing() => wrong.IsCsm && CsmLens.Difference(camera) is { } difference ? $" ({difference})" : string.Empty;
        string[] able = [.. All.Where(format => format.HasCamera && Has(format)).Select(format => format.Word)];
        string[] traits =
        [
            .. scan is not null ? ["a camera that scans"] : (string[])[],
            .. camera.Distortion is { } lens ? [$"the lens '{lens.Name}' with these coefficients{Missing()}"] : (string[])[],
            .. camera.Skew != 0.0 ? ["skew pixels"] : (string[])[],
        ];
        throw new BadInputException(
            $"the camera model {wrong.Word} can't say {string.Join(" and ", traits)}. "
                + (able.Length > 0 ? $"Formats that can: {string.Join(", ", able)}."
                    : $"No format can: use K, {(scan is not null ? "rows" : "R, t")} and lens of the XML."));
    }

    /// <summary>Writes the files of formats.</summary>
    /// <param name="put">Receives them.</param>
    /// <param name="note">Gets how exact the model of a scan is, one line.</param>
    /// <param name="warn">The same where it is less exact than promised.</param>
    public static void Write(
        IEnumerable<CameraFormat> formats, PutFile put, ExportedFrame frame, Action<string> note, Action<string> warn)
    {
        ExportedFrame written = frame;
        bool isCsm = formats.Any(format => format.IsCsm);
        if (isCsm && CsmLens.Difference(frame.Camera.Model) is { } difference)
        {
            (CsmLens.Of(frame.Camera.Model).Misfit > CsmScan.Promised ? warn : note)($"Camera model of {frame.Name}: {difference}.");
        }

        if (frame.Scan is { } scan && isCsm)
        {
            CsmScan csm = CsmScan.Of(frame.Camera.Model, scan);
            written = frame with { Csm = csm };
            (csm.Misfit > CsmScan.Promised ? warn : note)(csm.Describe(frame.Name, scan.Period));
        }

        foreach (ExportedFile file in formats.SelectMany(format => format._files))
        {
            put(file.Ending[1..], null, stream => file.Write(stream, written));
        }
    }

    private static ExportedFile Text(string ending, Action<TextWriter, ExportedFrame> write) =>
        new(ending, (stream, frame) =>
        {
            using StreamWriter writer = AtomicFileSet.TextWriterOn(stream);
            write(writer, frame);
        });

    private static ExportedFile Bytes(string ending, Action<Stream, ExportedFrame> write) =>
        new(ending, write);

    private sealed record ExportedFile(string Ending, Action<Stream, ExportedFrame> Write);
}
