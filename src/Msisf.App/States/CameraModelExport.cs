using Msisf.Adapters.CameraExport;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Time;

namespace Msisf.App.States;

/// <summary><c>msis camera-model</c>: writes the cameras of meta files for other programs.</summary>
internal static class CameraModelExport
{
    /// <exception cref="MsisfException">A file can't be read, or a format can't say its camera.</exception>
    public static void Write(OptionValues values, ProgramHost host)
    {
        IReadOnlyList<CameraFormat> formats = CameraModelOptions.ReadTo(values);
        EphemerisChoice engine = LightOptions.Ephemeris.Read(values);
        IReadOnlyList<string> kernels = LightOptions.Kernels.ReadAll(values);
        if (values.Arguments.Count == 0)
        {
            throw new UsageException("msis camera-model needs one meta file or more: name them (.xml).");
        }

        TimeScale scale = EphemerisSource.ReadTimeScale(host, kernels);
        List<string> paths = [];
        using AtomicFileSet files = new();
        foreach (string metaFile in values.Arguments)
        {
            ExportedFrame frame = MetaFileFrame.Read(metaFile, scale);
            CameraModel camera = frame.Camera.Model;
            Named(metaFile, () => CameraFormat.Require(formats, camera, frame.Scan?.Kind));
            if (frame is { IsMoving: true, Scan: null } && formats.Any(format => format.NeedsEphemeris))
            {
                host.Log.Warning($"{metaFile}: the camera moved while it was exposed, and the model is that of the frame's time. For a "
                    + "rolling shutter, --camera-model in the run itself has the time of each row.");
            }

            using OpenedEphemeris? opened = formats.Any(format => format.NeedsEphemeris)
                ? EphemerisSource.Open(host, engine, frame.Globe.Body, kernels, SpacecraftKernels.None)
                : null;
            string stem = Path.ChangeExtension(metaFile, null);
            ExportedFrame exported = frame with
            {
                Ephemeris = opened?.Engine,
                Image = formats.Any(format => format.HasPixels) ? ExportedImage.Read(metaFile, frame) : null,
            };
            CameraFormat.Write(formats, files.Under(stem, paths), exported, host.Log.Note, host.Log.Warning);
        }

        files.Commit();
        paths.ForEach(host.Results.WriteLine);
    }

    private static void Named(string metaFile, Action work)
    {
        try
        {
            work();
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{metaFile}: {exception.Message}", exception);
        }
    }
}
