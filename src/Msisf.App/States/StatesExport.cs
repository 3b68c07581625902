using Msisf.Adapters.Input;
using Msisf.Adapters.IO;
using Msisf.Adapters.States;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.App.States;

/// <summary>Writes the states of a run for other programs.</summary>
internal static class StatesExport
{
    /// <summary>Reads the run's states and writes them; all files, or none.</summary>
    /// <param name="path">File or folder; null to print.</param>
    /// <exception cref="MsisfException">The run can't be read, or the form can't hold it.</exception>
    public static void Write(
        TrajectorySettings trajectory, RenderSettings settings, StatesFormat format, string? path, ProgramHost host,
        CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        using ModelOnDemand model = new(settings, host, cancellation);
        RunGeometry geometry = new(() => model.Opened, ephemeris.Engine, settings.Aberration, settings.Body);
        StateReader reader = new(ephemeris.Engine, geometry, host)
        {
            Body = settings.Body,
            Kernels = ephemeris.Kernels,
            Needs =
            [
                new StateNeeds
                {
                    FindsMotions = settings.Scan is null && settings.Jitter is null,
                    Scan = settings.Scan,
                    Jitter = settings.Jitter,
                    Mounting = settings.Rig?.Mounting,
                },
            ],
        };
        IReadOnlyList<SpacecraftState> all = reader.Read(trajectory, cancellation);
        IReadOnlyList<string> names = new FrameNaming(settings.OutputName, settings.Rig?.Name)
            .NamesOf([.. all.Select(state => state.Time)]);
        int[] steps = [.. settings.StepsOf(all.Count).Select(step => step - 1)];
        SpacecraftState[] states = [.. steps.SelectMany(step => ScanStates.ExposuresOf(all[step]))];
        string[] chosen = [.. steps.SelectMany(step => NamesOf(all[step], names[step]))];
        string head = $"states of msis {host.Version}";
        if (path is null)
        {
            WriteTable(host.Results, format, head, states);
            return;
        }

        if (format == StatesFormat.Spice && SpiceKernelWriter.LensLeftOut(settings.CameraModel) is { } lens)
        {
            host.Log.Warning($"--format spice: {lens}.");
        }

        MakeFolders(format, path);
        using AtomicFileSet files = new();
        string[] written = format switch
        {
            StatesFormat.Oem => WriteCcsds(files, path, head, InertialState.Of(states, ephemeris.Engine())),
            StatesFormat.Spice => WriteKernels(
                files, path, new SpiceKernelWriter(head, InertialState.Of(states, ephemeris.Engine())), settings.CameraModel),
            StatesFormat.Euroc => WriteEuroc(files, path, states, chosen, settings.CameraModel),
            StatesFormat.Colmap => WriteColmap(files, path, states, chosen, settings.CameraModel),
            _ => WriteText(files, [(path, writer => WriteTable(writer, format, head, states))]),
        };
        files.Commit();
        foreach (string file in written)
        {
            host.Results.WriteLine(file);
        }
    }

    /// <summary>A name for each exposure: that of the image, with its number where there are several.</summary>
    private static IEnumerable<string> NamesOf(SpacecraftState state, string name) => state.Path is { States.Count: > 1 } path
        ? Enumerable.Range(1, path.States.Count).Select(number => Invariant($"{name}.{number:00000}"))
        : [name];

    private static void MakeFolders(StatesFormat format, string path)
    {
        string[] folders = format switch
        {
            StatesFormat.Batch or StatesFormat.Csv or StatesFormat.Tum => [],
            StatesFormat.Euroc => [EurocCamera(path), EurocTruth(path)],
            _ => [path],
        };
        foreach (string folder in folders)
        {
            FileErrors.ToExternalPart($"{folder}: the folder can't be made", () => Directory.CreateDirectory(folder));
        }
    }

    private static string EurocCamera(string folder) => Path.Combine(folder, "mav0", "cam0");

    private static string EurocTruth(string folder) => Path.Combine(folder, "mav0", "state_groundtruth_estimate0");

    private static void WriteTable(TextWriter writer, StatesFormat format, string head, SpacecraftState[] states)
    {
        switch (format)
        {
            case StatesFormat.Csv:
                StateTables.WriteCsv(writer, states);
                break;
            case StatesFormat.Tum:
                StateTables.WriteTum(writer, states);
                break;
            default:
                bool hasMotion = states.All(state => state.Motion is not null);
                BatchFileWriter.Write(
                    writer,
                    $"{head}: MJD in UTC; m along MOON_ME; the quaternion (scalar q0 last) turns camera axes (looks along -x, y right, "
                        + "z up) into MOON_ME",
                    hasMotion ? states : [.. states.Select(state => state with { Motion = null })]);
                break;
        }
    }

    private static string[] WriteCcsds(AtomicFileSet files, string folder, string head, InertialState[] states) => WriteText(
        files,
        [
            (Path.Combine(folder, "states.oem"), writer => CcsdsWriter.WriteOem(writer, head, states)),
            (Path.Combine(folder, "states.aem"), writer => CcsdsWriter.WriteAem(writer, head, states)),
        ]);

    private static string[] WriteKernels(AtomicFileSet files, string folder, SpiceKernelWriter kernels, CameraModel camera)
    {
        string[] texts = WriteText(
            files,
            [
                (Path.Combine(folder, "states.tsc"), kernels.WriteClock), (Path.Combine(folder, "states.tf"), kernels.WriteFrame),
                (Path.Combine(folder, "states.ti"), writer => kernels.WriteInstrument(writer, camera)),
            ]);
        string spk = Path.Combine(folder, "states.bsp");
        string ck = Path.Combine(folder, "states.bc");
        files.Write(spk, kernels.WriteSpk);
        files.Write(ck, kernels.WriteCk);
        return [.. texts, spk, ck];
    }

    private static string[] WriteEuroc(
        AtomicFileSet files, string folder, SpacecraftState[] states, string[] names, CameraModel camera)
    {
        (string camera0, string truth) = (EurocCamera(folder), EurocTruth(folder));
        return WriteText(
            files,
            [
                (Path.Combine(camera0, "data.csv"), writer => StateTables.WriteEurocImages(writer, states, names)),
                (Path.Combine(camera0, "sensor.yaml"), writer => CameraTables.WriteEurocSensor(writer, camera)),
                (Path.Combine(truth, "data.csv"), writer => StateTables.WriteEurocStates(writer, states)),
                (Path.Combine(truth, "sensor.yaml"), writer => writer.Write(StateTables.EurocStatesYaml)),
            ]);
    }

    private static string[] WriteColmap(
        AtomicFileSet files, string folder, SpacecraftState[] states, string[] names, CameraModel camera) => WriteText(
        files,
        [
            (Path.Combine(folder, "cameras.txt"), writer => CameraTables.WriteColmapCamera(writer, camera)),
            (Path.Combine(folder, "images.txt"), writer => CameraTables.WriteColmapImages(writer, states, names)),
            (Path.Combine(folder, "points3D.txt"), CameraTables.WriteColmapPoints),
        ]);

    private static string[] WriteText(AtomicFileSet files, (string Path, Action<TextWriter> Write)[] texts)
    {
        foreach ((string path, Action<TextWriter> write) in texts)
        {
            files.WriteText(path, write);
        }

        return [.. texts.Select(text => text.Path)];
    }
}
