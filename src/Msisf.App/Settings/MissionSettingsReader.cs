using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>Reads how a camera flies by the files of a mission, and which options are combined.</summary>
/// <param name="readAttitude">Reads the quaternion; null if there is none.</param>
/// <param name="readTimes">Reads the times that the user gives.</param>
internal sealed class MissionSettingsReader(
    OptionValues values, Func<AttitudeTransition?> readAttitude, Func<IEnumerable<CalendarTime>> readTimes)
{
    private static readonly OptionSpec[] TimeOptions =
        [CameraOptions.Time, CameraOptions.Times, CameraOptions.TimeInterval, MissionOptions.Every];

    /// <summary>What only a quaternion needs.</summary>
    private static readonly OptionSpec[] OfQuaternion =
        [CameraOptions.Epoch, CameraOptions.AttitudeTransition, CameraOptions.AttitudeFrame];

    /// <param name="way">The option that says where the camera is.</param>
    /// <exception cref="MsisfException">A value is wrong, or an option is missing or not allowed.</exception>
    public MissionSettings Read(OptionSpec way)
    {
        values.Refuse([CameraOptions.OrbitFrame, CameraOptions.Motion], $"is not allowed with {way.Name}, whose files say it. Remove it.");
        values.RequireTimes(way, TimeOptions);
        double? every = MissionOptions.Every.ReadIfGiven(values);
        return new MissionSettings(
            Position(way), Attitude(way), every is null ? readTimes() : null, every)
        {
            OfGround = MissionOptions.OfGround.Read(values),
        };
    }

    private PositionSource Position(OptionSpec way) => way is PathSpec file
        ? new FilePosition(file.Read(values), file)
        : new KernelPosition(MissionOptions.Spacecraft.Read(values));

    private AttitudeChoice Attitude(OptionSpec way)
    {
        if (MissionOptions.Aem.ReadIfGiven(values) is { } path)
        {
            values.Refuse(
                [CameraOptions.Attitude, .. OfQuaternion, MissionOptions.Ck, .. PointingOptions.OfPosition],
                $"and {MissionOptions.Aem.Name} exclude each other: both say how the camera points. Leave one out.");
            return new AemChoice(path, CameraOptions.Normalize.Read(values), ReadAxes(values));
        }

        bool isPointed = PointingOptions.OfPosition.Any(values.IsGiven);
        bool isGiven = isPointed || values.IsGiven(CameraOptions.Attitude);
        if (isGiven)
        {
            values.Refuse(
                [MissionOptions.Ck, MissionOptions.InstrumentAxes],
                "has no meaning where --attitude, --look-at, --off-nadir, --up or --roll says how the camera points. Leave one out.");
        }
        else if (MissionOptions.Instrument.ReadIfGiven(values) is { } instrument)
        {
            values.Refuse(
                OfQuaternion, $"has no meaning with {MissionOptions.Instrument.Name}, whose kernels say the attitude. Remove it.");
            return new InstrumentChoice(instrument, ReadAxes(values));
        }

        values.Refuse(
            values.IsGiven(MissionOptions.Instrument) ? [] : [MissionOptions.Ck, MissionOptions.InstrumentAxes],
            $"needs {MissionOptions.Instrument.Name}: whose attitude the camera has. Add it.");
        if (readAttitude() is not { } attitude)
        {
            values.Refuse(OfQuaternion, $"has no meaning with {way.Name} without {CameraOptions.Attitude.Name}. Remove it.");
            return new PointedChoice(PointingOptions.ReadPointing(values));
        }

        if (isPointed)
        {
            values.Refuse(
                PointingOptions.OfPosition,
                $"and {CameraOptions.Attitude.Name} exclude each other: both say how the camera points. Leave one out.");
        }

        AttitudeFrame frame = CameraOptions.AttitudeFrame.Read(values);
        bool hasEpoch = values.IsGiven(CameraOptions.Epoch);
        bool needsEpoch = frame == AttitudeFrame.MoonMeEpoch || values.IsGiven(CameraOptions.AttitudeTransition);
        if (hasEpoch != needsEpoch)
        {
            throw new UsageException(needsEpoch
                ? $"{CameraOptions.Attitude.Name} needs {CameraOptions.Epoch.Name} here: the time from which the camera turns, or whose "
                    + "axes are meant."
                : $"{CameraOptions.Epoch.Name} has no meaning with {way.Name} and an attitude that does not change. Remove it.");
        }

        return new QuaternionChoice(attitude, frame, hasEpoch ? CameraOptions.Epoch.Read(values) : null);
    }

    /// <summary>Reads how the image lies in the instrument's axes; null if the user does not say it.</summary>
    public static InstrumentAxes? ReadAxes(OptionValues values) => MissionOptions.InstrumentAxes.ReadIfGiven(values) is { } axes
        ? MissionOptions.InstrumentAxes.Named(() => InstrumentAxes.Parse(axes))
        : null;
}
