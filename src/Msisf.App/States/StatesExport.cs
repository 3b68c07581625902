using Msisf.Adapters.IO;
using Msisf.Adapters.Input;
using Msisf.Adapters.States;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.States;

/// <summary>Writes the states of a run for other programs.</summary>
internal static class StatesExport
{
    /// <summary>Reads the run's states and writes them, of a rig for each camera; all files of a camera, or none.</summary>
    /// <param name="cameras">Settings of each camera of the rig, or of the only one.</param>
    /// <param name="path">File or folder, of a rig with {camera} in it but for COLMAP; null to print.</param>
    /// <exception cref="MsisfException">The run can't be read, or the form can't hold it.</exception>
    public static void Write(
        TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras, StatesFormat format, string? path, ProgramHost host,
        CancellationToken cancellation)
    {
        if (format == StatesFormat.Colmap && path is not null && cameras[0].Rig is not null)
        {
            WriteRig(trajectory, cameras, path, host, cancellation);
            return;
        }

        foreach (RenderSettings camera in cameras)
        {
            Write(trajectory, camera, format, RigOptions.PathOf(path, camera.Rig), host, cancellation);
        }
    }

    /// <summary>Writes all cameras of a rig as one model of COLMAP.</summary>
    private static void WriteRig(
        TrajectorySettings trajectory, IReadOnlyList<RenderSettings> cameras, string folder, ProgramHost host,
        CancellationToken cancellation)
    {
        if (folder.Contains(RigOptions.CameraField, StringComparison.Ordinal))
        {
            throw new UsageException(
                $"a model of COLMAP has all cameras of a rig. Give {StatesOptions.To.Name} a folder without {RigOptions.CameraField}.")
                .About(StatesOptions.To, RigOptions.Rig);
        }

        NamedStates[] all = [.. cameras.Select(camera => Read(trajectory, camera, host, cancellation))];
        MakeFolders(StatesFormat.Colmap, folder);
        using AtomicFileSet files = new();
        string[] written = WriteColmap(files, folder, all);
        files.Commit();
        Array.ForEach(written, host.Results.WriteLine);
    }

    private static NamedStates Read(
        TrajectorySettings trajectory, RenderSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        return Read(trajectory, settings, ephemeris, host, cancellation);
    }

    private static NamedStates Read(
        TrajectorySettings trajectory, RenderSettings settings, EphemerisSource ephemeris, ProgramHost host,
        CancellationToken cancellation)
    {
        using ModelOnDemand model = new(settings, host, cancellation);
        RunGeometry geometry = new(() => model.Opened, ephemeris.Engine, ephemeris.TimeScale, settings.Aberration, settings.Body);
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
        int[] steps = [.. settings.StepsOf(all.Count).Select(step => step - 1)];
        FrameNaming naming = new(settings.OutputName, settings.Rig?.Name);
        return new NamedStates(settings.CameraModel, [.. steps.SelectMany(step => ScanStates.ExposuresOf(all[step]))], Names);

        string[] Names()
        {
            IReadOnlyList<string> names = naming.NamesOf([.. all.Select(state => state.Time)]);
            return [.. steps.SelectMany(step => NamesOf(all[step], names[step]))];
        }
    }

    private static void Write(
        TrajectorySettings trajectory, RenderSettings settings, StatesFormat format, string? path, ProgramHost host,
        CancellationToken cancellation)
    {
        using EphemerisSource ephemeris = new(settings, host);
        NamedStates read = Read(trajectory, settings, ephemeris, host, cancellation);
        SpacecraftState[] states = read.States;
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
            StatesFormat.Euroc => WriteEuroc(files, path, states, read.Names(), settings.CameraModel),
            StatesFormat.Colmap => WriteColmap(files, path, [read]),
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

    private static string[] WriteColmap(AtomicFileSet files, string folder, NamedStates[] cameras) => WriteText(
        files,
        [
            (Path.Combine(folder, "cameras.txt"),
                writer => CameraTables.WriteColmapCameras(writer, [.. cameras.Select(camera => camera.Camera)])),
            (Path.Combine(folder, "images.txt"),
                writer => CameraTables.WriteColmapImages(writer, [.. cameras.Select(camera => (camera.States, camera.Names()))])),
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

    /// <summary>The states of a camera, with the names of their images, which only some formats need.</summary>
    private sealed record NamedStates(CameraModel Camera, SpacecraftState[] States, Func<string[]> Names);
}
