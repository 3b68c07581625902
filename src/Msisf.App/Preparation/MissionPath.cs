using Msisf.Adapters.Camera;
using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Trajectories;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>The path of a camera that flies as the files of a mission say.</summary>
/// <param name="Path">Its pose at each time.</param>
/// <param name="Scale">Time scale of the kernels' leap seconds.</param>
internal sealed record MissionPath(SpacecraftPath Path, TimeScale Scale)
{
    /// <summary>Maximum number of images of --every; a frame a second for four months.</summary>
    private const double MaxImages = 10_000_000.0;

    private static readonly Duration Microsecond = Duration.OfSeconds(0.000_001m);

    /// <param name="settings">Where the spacecraft is, and how its camera points.</param>
    /// <param name="kernels">The engine with its kernels.</param>
    /// <param name="scene">Terrain and Sun.</param>
    /// <param name="note">Receives a sentence about what was put right in a file.</param>
    /// <exception cref="MsisfException">A file can't be read, or does not have what is asked for.</exception>
    public static MissionPath Open(
        MissionSettings settings, OpenedEphemeris kernels, ISceneGeometry scene, Action<string> note)
    {
        ITrajectory trajectory = settings.Position switch
        {
            KernelPosition position => MissionOptions.Spacecraft.NamedInErrors(() => new KernelTrajectory(kernels, position.Spacecraft)),
            FilePosition file => new SampledTrajectory(
                OpenFile(file.Option, "CCSDS_OE", file.Path, () => TrajectoryFile.Read(file.Path, file.Path, kernels, note)), file.Path,
                kernels.Engine),
            SampledPosition sampled => new SampledTrajectory(sampled.Blocks(kernels), sampled.Name, kernels.Engine),
            _ => throw new ArgumentException($"no trajectory is known of {settings.Position.GetType().Name}", nameof(settings)),
        };
        IAttitudeSource attitude = settings.Attitude switch
        {
            InstrumentChoice choice => MissionOptions.Instrument.NamedInErrors(() => Attitude(choice, kernels)),
            PointedChoice choice => new PointedAttitude(choice.Pointing, scene),
            QuaternionChoice choice => new FramedAttitude(
                choice.Attitude, choice.Frame, choice.Epoch is { } epoch ? kernels.Engine.TimeScale.InstantOf(epoch) : null,
                kernels.Engine),
            AemChoice aem => new SampledAttitude(
                OpenFile(MissionOptions.Aem, "CCSDS_AE", aem.Path, () =>
                {
                    using FileStream stream = new(
                        aem.Path, FileMode.Open, FileAccess.Read, FileShare.Read, 1 << 16, FileOptions.SequentialScan);
                    return new CcsdsFile(kernels, note).ReadAem(stream, aem.Path, aem.IsRounded);
                }),
                aem.Axes?.InstrumentFromCamera ?? UnitQuaternion.Identity, aem.Path, kernels.Engine.TimeScale),
            _ => throw new ArgumentException($"no attitude is known of {settings.Attitude.GetType().Name}", nameof(settings)),
        };
        SpacecraftPath path = new(trajectory, attitude, kernels.Engine)
        {
            OfGround = settings.OfGround,
            GroundRadius = scene.ReferenceRadius,
        };
        return new MissionPath(path, kernels.Engine.TimeScale);
    }

    /// <param name="settings">Times, or a step.</param>
    /// <exception cref="UsageException">The step gives too many images.</exception>
    public IEnumerable<Instant> Times(MissionSettings settings)
    {
        if (settings.Every is not { } step)
        {
            return settings.Times!.Select(Scale.InstantOf);
        }

        double count = Path.Cover.Intervals.Sum(interval => Math.Floor((interval.End - interval.Start) / step) + 1.0);
        return count <= MaxImages
            ? EachOnce(Path.Cover.Intervals.SelectMany(interval => Steps(interval, step, settings)))
            : throw MissionOptions.Every.Wrong(Invariant(
                $"{step:R} gives {count:E1} images; {MaxImages:#,0} is the most. The files cover "
                    + $"{new KernelCover(Scale, Path.Cover).Describe()}. Choose a longer step, or {CameraOptions.TimeInterval.Name}."));
    }

    /// <summary>Leaves out times that are the one before: short steps, and intervals that all but meet, are rounded to such.</summary>
    private static IEnumerable<Instant> EachOnce(IEnumerable<Instant> times)
    {
        Instant? last = null;
        foreach (Instant time in times)
        {
            if (time != last)
            {
                yield return time;
            }

            last = time;
        }
    }

    private static KernelAttitude Attitude(InstrumentChoice choice, OpenedEphemeris kernels)
    {
        InstrumentKernel instrument = new(kernels.Catalogue.Pool, choice.Instrument);
        return new KernelAttitude(kernels, instrument.Frame, choice.Axes ?? instrument.Axes());
    }

    private static T OpenFile<T>(PathSpec option, string start, string path, Func<T> read)
    {
        if (!File.Exists(path))
        {
            string what = Directory.Exists(path) ? "is a folder; a file is needed" : "there is no such file";
            throw new BadInputException($"{option.Name} {path}: {what}.");
        }

        option.NamedInErrors(() => KernelFile.Require(path, option.Name, start));
        return option.NamedInErrors(() => FileErrors.ToBadInput($"{path}: can't be read", read));
    }

    /// <summary>
    /// Times in an interval of the cover, SI seconds apart, and whole microseconds of UTC if the step is: the ends of a cover are doubles,
    /// which hold 0.1 microseconds of today's times. A file of samples is read so far past its ends; of kernels the ends themselves
    /// are taken.
    /// </summary>
    private IEnumerable<Instant> Steps(TdbInterval interval, double step, MissionSettings settings)
    {
        Instant first = Scale.InstantOf(Scale.InstantOf(interval.Start).Utc.RoundedTo(Microsecond));
        Duration length = Duration.OfDecimal(step);
        int count = (int)Math.Floor((interval.End - interval.Start) / step) + 1;
        for (int i = 0; i < count; i++)
        {
            if (interval.IsInstant)
            {
                yield return settings is { Position: KernelPosition, Attitude: not InstrumentChoice }
                    ? Scale.InstantOf(interval.Start)
                    : first;
                continue;
            }

            Instant time = first + (i * length);
            double tdbSeconds = time.Tdb.Seconds;
            yield return settings is { Position: not KernelPosition, Attitude: not InstrumentChoice } ? time
                : tdbSeconds < interval.Start ? Scale.InstantOf(interval.Start)
                : tdbSeconds > interval.End ? Scale.InstantOf(interval.End)
                : time;
        }
    }
}
