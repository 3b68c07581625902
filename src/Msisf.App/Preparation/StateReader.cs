using System.Text;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Adapters.Trajectories;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Reads the states of the spacecraft for the images of a run; all are known before the first image.</summary>
/// <param name="ephemeris">Opens the ephemeris, which not every orbit needs.</param>
/// <param name="geometry">Terrain and Sun, for cameras that are placed or pointed by them.</param>
internal sealed class StateReader(Func<IEphemeris> ephemeris, ISceneGeometry geometry, ProgramHost host)
{
    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>Opens the ephemeris with its kernels; only the files of a mission need it.</summary>
    public Func<OpenedEphemeris>? Kernels { get; init; }

    /// <summary>What the cameras need; more than one of a rig.</summary>
    public IReadOnlyList<StateNeeds> Needs { get; init; } = [new()];

    private bool NeedsMotion => Needs.Any(needs => needs.NeedsMotion);

    private string? CameraWithShutter => Needs.Select(needs => needs.CameraWithShutter).FirstOrDefault(name => name is not null);

    private bool NeedsPath => Needs.Any(needs => needs.NeedsPath);

    /// <summary>Reads or computes all states of the only camera.</summary>
    /// <inheritdoc cref="ReadBody"/>
    public IReadOnlyList<SpacecraftState> Read(TrajectorySettings trajectory, CancellationToken cancellation) =>
        Needs[0].Of(ReadBody(trajectory, cancellation), trajectory);

    /// <summary>Reads or computes all states, as <see cref="StateNeeds.Of(IReadOnlyList{SpacecraftState}, TrajectorySettings)"/> makes
    /// those of a camera of them.</summary>
    /// <exception cref="NothingToRenderException">There is no state.</exception>
    public IReadOnlyList<SpacecraftState> ReadBody(TrajectorySettings trajectory, CancellationToken cancellation)
    {
        foreach (string mistake in PlausibleMistakes.In(trajectory, Body))
        {
            host.Log.Warning(mistake);
        }

        ISceneGeometry scene = SceneWithSun.Of(geometry, trajectory.SunPositionBodyFixed);
        IReadOnlyList<SpacecraftState> states = trajectory switch
        {
            FixedStateSettings place => [place.State with { Time = scene.TimeScale.InstantOf(place.Time) }],
            BatchFileSettings file => BatchFile(file, scene, cancellation),
            PlaceSettings place => AtPlace(place, scene, cancellation),
            OrbitSettings orbit => OnOrbit(orbit, cancellation),
            MissionSettings mission => OnMission(mission, scene, cancellation),
            SampledSettings sampled => BetweenSamples(sampled, scene, cancellation),
            _ => throw new ArgumentException($"no states are known of {trajectory.GetType().Name}", nameof(trajectory)),
        };
        if (trajectory is BatchFileSettings)
        {
            foreach (string mistake in PlausibleMistakes.Speed(states.Select(state => state.Motion)))
            {
                host.Log.Warning(mistake);
            }
        }

        if (states.Count > 0 && LeapSecondNote.Of(trajectory, states) is { } note)
        {
            host.Log.Note(note);
        }

        return states.Count > 0
            ? WithOptions(states, trajectory)
            : throw new NothingToRenderException(trajectory is BatchFileSettings empty
                ? $"{NameOf(empty)}: no state in it: only comments and empty lines. Add lines of MJD rx ry rz qx qy qz q0, "
                    + "or below a header line of its columns."
                : "--time-interval: no time in it: the step leads away from the end. The order is start:step:end; swap start and end, "
                    + "or change the step's sign.");
    }

    /// <summary>The states with the Sun and the exposure of the options.</summary>
    private static IReadOnlyList<SpacecraftState> WithOptions(IReadOnlyList<SpacecraftState> states, TrajectorySettings trajectory)
    {
        if (trajectory.SunPositionBodyFixed is { } sun)
        {
            RefuseTwo(states.Any(state => state.SunPositionBodyFixed is not null), LightOptions.SunPosition, "where the Sun is");
            states = [.. states.Select(state => state with { SunPositionBodyFixed = sun })];
        }

        if (trajectory.ExposureFactor is { } factor)
        {
            RefuseTwo(states.Any(state => state.ExposureFactor is not null), NativeOptions.ExposureFactor, "the exposure");
            states = [.. states.Select(state => state with { ExposureFactor = factor })];
        }

        return states;
    }

    /// <summary>Refuses what an option and the states of a file both say.</summary>
    /// <param name="isInFile">Whether a state says it.</param>
    /// <exception cref="UsageException">It does.</exception>
    public static void RefuseTwo(bool isInFile, OptionSpec option, string what)
    {
        if (isInFile)
        {
            throw option.Wrong($"and the batch file both say {what}. Leave one out.");
        }
    }

    private static string NameOf(BatchFileSettings file) => file.IsStandardInput ? "standard input" : file.Path;

    // A read from a terminal or pipe can't be cancelled, so its thread is abandoned.
    private IReadOnlyList<SpacecraftState> BatchFile(BatchFileSettings file, ISceneGeometry scene, CancellationToken cancellation) =>
        Task.Run(() => BatchFile(file, scene), CancellationToken.None).WaitAsync(cancellation).GetAwaiter().GetResult();

    private IReadOnlyList<SpacecraftState> BatchFile(BatchFileSettings file, ISceneGeometry scene)
    {
        if (file.Content is { } content)
        {
            return States(new StringReader(content), file, scene);
        }

        if (file.IsStandardInput)
        {
            return States(host.StandardInput(), file, scene);
        }

        if (!File.Exists(file.Path))
        {
            throw new BadInputException(Directory.Exists(file.Path)
                ? $"{file.Option.Name} {file.Path}: is a folder; a file is needed."
                : $"{file.Option.Name} {file.Path}: there is no such file.");
        }

        try
        {
            RequireStates(file.Path);
            using StreamReader reader = new(file.Path, Encoding.UTF8);
            return States(reader, file, scene);
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new BadInputException($"{file.Option.Name} {file.Path}: can't be read: {exception.Message}", exception);
        }
    }

    /// <summary>Refuses files that are known to be something else.</summary>
    private static void RequireStates(string path)
    {
        KnownFormats.Refuse(path, FormatUse.States);
        if (TrajectoryFile.IsOne(path))
        {
            throw new BadInputException(
                $"{path}: this is a trajectory without attitudes (OEM, STK or Horizons). Give it with {MissionOptions.Oem.Name}.");
        }
    }

    private IReadOnlyList<SpacecraftState> States(TextReader reader, BatchFileSettings file, ISceneGeometry scene) => BatchFileReader.Read(
        reader, NameOf(file), scene, file.Conventions, host.Log.Warning, host.Log.Note);

    private SpacecraftState[] AtPlace(PlaceSettings settings, ISceneGeometry scene, CancellationToken cancellation)
    {
        Vector3D position = PointingOptions.Position.NamedInErrors(
            () => settings.Place.ToPositionBodyFixed(scene.GroundRadius, scene.ReferenceRadius));
        if (settings.Pointing.IsTargetHidden(position, scene))
        {
            host.Log.Warning($"{PointingOptions.LookAt.Name}: the place {PointingText.Hidden}");
        }

        return [.. settings.Times.Select(scene.TimeScale.InstantOf).Select(time =>
        {
            cancellation.ThrowIfCancellationRequested();
            return new SpacecraftState(time, position, settings.Pointing.MoonFromCamera(position, time, scene));
        })];
    }

    private SpacecraftState[] OnOrbit(OrbitSettings settings, CancellationToken cancellation)
    {
        Instant epoch = geometry.TimeScale.InstantOf(settings.Epoch);
        OrbitPropagator orbit = new(
            settings.Elements, epoch, settings.Frame, settings.Frame == OrbitFrame.MoonMe ? null : ephemeris());
        if (orbit.PeriapsisRadius < MoonConstants.ReferenceRadius)
        {
            host.Log.Warning(Invariant(
                $"the orbit's periapsis lies {(MoonConstants.ReferenceRadius - orbit.PeriapsisRadius) / 1000.0:F3} km below the Moon's "
                    + $"reference radius; times on that part are refused."));
        }

        foreach (string note in OrbitNotes.Of(settings))
        {
            host.Log.Note(note);
        }

        AttitudeFrame frame = settings.AttitudeFrame ?? AttitudeFrame.MoonMe;
        FramedAttitude? attitude = settings.Attitude is { } transition
            ? new FramedAttitude(
                transition, frame, epoch, frame is AttitudeFrame.MoonMe or AttitudeFrame.Lvlh ? null : ephemeris())
            : null;
        OrbitPath path = new(orbit, attitude);
        return [.. settings.Times.Select(geometry.TimeScale.InstantOf).Select(time =>
        {
            cancellation.ThrowIfCancellationRequested();
            CameraState camera = path.At(time);
            return new SpacecraftState(time, camera.PositionBodyFixed, camera.MoonFromCamera)
            {
                Path = NeedsPath
                    ? new ScanPath(seconds => path.At(time.After(seconds)), seconds => path.MotionAt(time.After(seconds)))
                    : null,
                Motion = NeedsMotion ? path.MotionAt(time) : null,
            };
        })];
    }

    private SpacecraftState[] BetweenSamples(SampledSettings settings, ISceneGeometry scene, CancellationToken cancellation)
    {
        IReadOnlyList<SpacecraftState> samples = BatchFile(settings.Samples, scene, cancellation);
        SampledMotion motion = ScanStates.MotionOf(samples, settings);
        IEnumerable<Instant> times = settings.Times?.Select(geometry.TimeScale.InstantOf) ?? [motion.Start];
        return [.. times.Select(time => ScanStates.Between(motion, time, settings.Samples.Path) with
        {
            Motion = NeedsMotion ? ScanStates.MotionAbout(motion, time) : null,
        })];
    }

    private SpacecraftState[] OnMission(MissionSettings settings, ISceneGeometry scene, CancellationToken cancellation)
    {
        if (settings.Position is FilePosition file && !Body.IsMoon)
        {
            throw file.Option.Wrong($"reads trajectories about Moon and Earth, but {Body.NameInText} is drawn. Give an SPK.");
        }

        OpenedEphemeris kernels = Kernels?.Invoke() ?? throw new InvalidOperationException("no kernels are given");
        MissionPath mission = MissionPath.Open(settings, kernels, scene, host.Log.Note);
        return [.. mission.Times(settings).Select(time =>
        {
            cancellation.ThrowIfCancellationRequested();
            SpacecraftState state = mission.Path.StateAt(time) with
            {
                Sky = Needs.Any(needs => needs.HasSky) ? mission.Path.Observer : null,
                Path = NeedsPath
                    ? new ScanPath(
                        seconds => mission.Path.At(time.After(seconds)), seconds => mission.Path.StatedMotionAt(time.After(seconds)))
                    : null,
            };
            return NeedsMotion ? state with { Motion = StateMotions.About(time, mission.Path, CameraWithShutter) } : state;
        })];
    }
}
