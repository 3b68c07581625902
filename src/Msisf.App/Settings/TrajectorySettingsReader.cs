using Msisf.Adapters.Input;
using Msisf.Adapters.Trajectories;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>
/// Reads the positions of the camera, given in one of the four ways of thesis table 6.1 or by a place, and checks which options are
/// combined.
/// </summary>
internal sealed class TrajectorySettingsReader
{
    private static readonly OptionSpec[] TimeOptions = [CameraOptions.Time, CameraOptions.Times, CameraOptions.TimeInterval];

    private static readonly OptionSpec[] OrbitOptions =
    [
        CameraOptions.Epoch, CameraOptions.Attitude, CameraOptions.AttitudeTransition, CameraOptions.AttitudeFrame,
        CameraOptions.OrbitFrame,
    ];

    private readonly OptionValues _values;
    private readonly PathSpec _batchFile;

    private TrajectorySettingsReader(OptionValues values, PathSpec batchFile) => (_values, _batchFile) = (values, batchFile);

    /// <summary>The options for the position of the camera, of which exactly one must be given.</summary>
    private OptionSpec[] Ways =>
        [
            CameraOptions.KeplerSet, CameraOptions.StateVectors, CameraOptions.FixedState, _batchFile, ScanOptions.Trajectory,
            PointingOptions.Position,
            .. MissionOptions.Ways,
        ];

    /// <exception cref="MsisfException">
    /// No way or several ways are given, an option is missing or not allowed, or a value is wrong.
    /// </exception>
    public static TrajectorySettings Read(OptionValues values)
    {
        TrajectorySettingsReader reader = new(values, CameraOptions.BatchFile);
        return reader.ReadIfGiven()
            ?? throw new UsageException($"nothing says where the camera is. Give exactly one of {reader.Ways.Names()}.");
    }

    /// <summary>Reads and checks the options; null if none of the ways is given.</summary>
    /// <param name="batchFile">The option that names the batch file, which has another name in msis patterns.</param>
    /// <inheritdoc cref="Read"/>
    public static TrajectorySettings? ReadIfGiven(OptionValues values, PathSpec batchFile) =>
        new TrajectorySettingsReader(values, batchFile).ReadIfGiven();

    /// <summary>Reads the noise of the first frame; null if the user does not choose it.</summary>
    public static NoiseSeed? ReadNoise(OptionValues values) => NativeOptions.NoiseSeed.ReadIfGiven(values) is { } text
        ? NativeOptions.NoiseSeed.Named(() => NoiseSeedText.Parse(text, step: 1))
        : null;

    /// <summary>Whether a mission's files say where the camera is; --trajectory takes those of --oem too.</summary>
    public static bool IsMission(OptionValues values) => MissionOptions.Ways.Any(values.IsGiven)
        || (ScanOptions.Trajectory.ReadIfGiven(values) is { } path && File.Exists(path) && TrajectoryFile.IsOne(path));

    private TrajectorySettings? ReadIfGiven() => ReadPlaces() is { } settings
        ? settings with
        {
            Noise = ReadNoise(_values),
            SunPositionBodyFixed = SunPosition(),
            ExposureFactor = NativeOptions.ExposureFactor.ReadIfGiven(_values),
        }
        : null;

    private TrajectorySettings? ReadPlaces()
    {
        OptionSpec[] given = [.. Ways.Where(_values.IsGiven)];
        if (given.Length > 1)
        {
            throw new UsageException($"{given[0].Name} and {given[1].Name} exclude each other. Give exactly one of {Ways.Names()}.");
        }

        if (given is not [OptionSpec way])
        {
            _values.Refuse(MissionOptions.All, $"needs one of {MissionOptions.Ways.Names()}: what says where the camera is. Add it.");
            return null;
        }

        bool isMission = IsMission(_values);
        if (way == ScanOptions.Trajectory && !isMission)
        {
            return Sampled();
        }

        _values.Refuse(
            isMission ? [.. ScanOptions.OfTrajectory.Except([way])] : ScanOptions.OfTrajectory,
                $"is not allowed with {way.Name}, but with {ScanOptions.Trajectory.Name} only. Remove it.");
        if (way != _batchFile)
        {
            _values.Refuse(BatchOptions.All, $"is not allowed with {way.Name}, but with {_batchFile.Name} only. Remove it.");
        }

        if (way != CameraOptions.FixedState && way != _batchFile && !_values.IsGiven(CameraOptions.Attitude)
            && !_values.IsGiven(MissionOptions.Aem) && !_values.IsGiven(RigOptions.Rig))
        {
            _values.Refuse([CameraOptions.Normalize], "has no meaning: nothing gives a quaternion. Remove it.");
        }

        if (isMission)
        {
            return new MissionSettingsReader(_values, Attitude, Times).Read(way);
        }

        _values.Refuse(MissionOptions.All, $"is not allowed with {way.Name}, but with {MissionOptions.Ways.Names()} only. Remove it.");
        CameraMotion? motion = Motion();
        if (way == PointingOptions.Position)
        {
            _values.Refuse(
                OrbitOptions, $"is not allowed with {way.Name}. Remove it; --look-at or --off-nadir says how the camera points.");
            _values.RequireTimes(way, TimeOptions);
            return new PlaceSettings(
                PointingOptions.ReadPosition(_values), PointingOptions.ReadPointing(_values), Times())
            {
                Motion = motion,
            };
        }

        _values.Refuse(
            PointingOptions.OfPosition, $"is not allowed with {way.Name}, but with {PointingOptions.Position.Name} only. Remove it.");
        if (way == CameraOptions.KeplerSet || way == CameraOptions.StateVectors)
        {
            _values.Refuse([CameraOptions.Motion], $"is not allowed with {way.Name}, which itself says how the camera moves. Remove it.");
        }

        if (way == CameraOptions.KeplerSet)
        {
            return Orbit(way, KeplerElements);
        }

        if (way == CameraOptions.StateVectors)
        {
            return Orbit(way, StateVectors);
        }

        bool isBatch = way == _batchFile;
        _values.Refuse(
            [.. OrbitOptions.Where(option => !isBatch || option != CameraOptions.Epoch), .. TimeOptions],
            $"is not allowed with {way.Name}, which itself says time, position and orientation. Remove it.");
        return isBatch
            ? new BatchFileSettings(_batchFile.Read(_values), _batchFile) { Motion = motion, Conventions = BatchOptions.Read(_values) }
            : FixedState() with { Motion = motion };
    }

    private SampledSettings Sampled()
    {
        _values.Refuse(
            [
                .. OrbitOptions.Except([CameraOptions.Epoch]), .. MissionOptions.All, .. PointingOptions.OfPosition, CameraOptions.Motion,
            ],
            $"is not allowed with {ScanOptions.Trajectory.Name}, whose file says how the camera moves. Remove it.");
        bool hasTimes = TimeOptions.Any(_values.IsGiven);
        if (hasTimes)
        {
            _values.RequireTimes(ScanOptions.Trajectory, TimeOptions);
        }

        BatchFileSettings samples = new(ScanOptions.Trajectory.Read(_values), ScanOptions.Trajectory)
        {
            Conventions = BatchOptions.Read(_values),
        };
        return samples.IsStandardInput
            ? throw ScanOptions.Trajectory.Wrong("can't be read from standard input. Save the states to a file.")
            : new SampledSettings(samples, hasTimes ? Times() : null)
            {
                Positions = ScanOptions.Positions.ReadIfGiven(_values),
                Attitudes = ScanOptions.Attitudes.ReadIfGiven(_values),
            };
    }

    private FixedStateSettings FixedState()
    {
        (CalendarTime time, double[] numbers) = CameraOptions.FixedState.ReadState(_values)!.Value;
        return CameraOptions.FixedState.Named(() => new FixedStateSettings(
            time, SpacecraftState.FromNumbers(default, numbers, isRounded: CameraOptions.Normalize.Read(_values))));
    }

    private CameraMotion? Motion() => CameraOptions.Motion.Read(_values) is { } numbers
        ? CameraOptions.Motion.Named(() => CameraMotion.FromNumbers(numbers))
        : null;

    private Vector3D? SunPosition()
    {
        if (LightOptions.SunPosition.Read(_values) is not { } numbers)
        {
            return null;
        }

        return LightOptions.IgnoreSun.Read(_values)
            ? throw LightOptions.SunPosition.Wrong(
                $"has no meaning with {LightOptions.IgnoreSun.Name}. Leave one out.", LightOptions.IgnoreSun)
            : LightOptions.SunPosition.Named(
                () => SpacecraftState.CheckedSun(new Vector3D(numbers[0], numbers[1], numbers[2])));
    }

    private OrbitSettings Orbit(OptionSpec way, Func<KeplerElements> readElements)
    {
        if (!_values.IsGiven(CameraOptions.Epoch))
        {
            throw new UsageException(
                $"{way.Name} needs {CameraOptions.Epoch.Name}: the time (MJD or ISO 8601, UTC) for which the orbit is given.");
        }

        _values.RequireTimes(way, TimeOptions);
        if (_values.IsGiven(CameraOptions.AttitudeTransition) && !_values.IsGiven(CameraOptions.Attitude))
        {
            throw new UsageException("--attitude-transition needs --attitude: the orientation at the epoch from which it turns.");
        }

        if (_values.IsGiven(CameraOptions.AttitudeFrame) && !_values.IsGiven(CameraOptions.Attitude))
        {
            throw new UsageException("--attitude-frame needs --attitude: without it the camera looks at the nadir. Give both or none.");
        }

        return new OrbitSettings(
            readElements(),
            CameraOptions.Epoch.Read(_values),
            CameraOptions.OrbitFrame.Read(_values),
            _values.IsGiven(CameraOptions.OrbitFrame),
            Attitude(),
            _values.IsGiven(CameraOptions.AttitudeFrame) ? CameraOptions.AttitudeFrame.Read(_values) : null,
            Times());
    }

    private KeplerElements KeplerElements()
    {
        double[] k = CameraOptions.KeplerSet.Read(_values)!;
        return CameraOptions.KeplerSet.Named(() => new KeplerElements(k[0], k[1], k[2], k[3], k[4], k[5]));
    }

    private KeplerElements StateVectors()
    {
        double[] s = CameraOptions.StateVectors.Read(_values)!;
        return CameraOptions.StateVectors.Named(
            () => StateConversion.ToElements(new StateVector(new Vector3D(s[0], s[1], s[2]), new Vector3D(s[3], s[4], s[5]))));
    }

    private AttitudeTransition? Attitude()
    {
        if (CameraOptions.Attitude.Read(_values) is not { } q)
        {
            return null;
        }

        double[] rates = CameraOptions.AttitudeTransition.Read(_values) ?? [0.0, 0.0, 0.0];
        return CameraOptions.Attitude.Named(() => new AttitudeTransition(
            UnitQuaternion.FromComponents(q[0], q[1], q[2], q[3], CameraOptions.Normalize.Read(_values)),
            new Vector3D(rates[0], rates[1], rates[2])));
    }

    private IEnumerable<CalendarTime> Times()
    {
        if (_values.IsGiven(CameraOptions.Time))
        {
            return [CameraOptions.Time.Read(_values)];
        }

        return CameraOptions.Times.ReadTimes(_values) is { } times
            ? times
            : CameraOptions.TimeInterval.Value(
                () => StateText.ParseInterval(CameraOptions.TimeInterval.Name, _values.Words(CameraOptions.TimeInterval)!));
    }
}
