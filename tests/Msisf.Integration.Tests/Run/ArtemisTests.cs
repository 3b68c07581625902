using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using Msisf.Integration.Tests.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>A real OEM: Artemis I as flown. What lies between its lines is held against lines that were left out.</summary>
public sealed class ArtemisTests
{
    /// <summary>Lines of the polynomial on either side, with one in two left out.</summary>
    private const int Reach = 8;

    /// <summary>
    /// Every second line is left out. Away from places where the file's parts were joined (its own contradictions), half of the left-out
    /// lines are met to 0.1 mm, and 99 of 100 to half a metre. The rest are 8 minutes apart, at the burns 130 km over the Moon.
    /// </summary>
    [RequiresFact(Part.Artemis)]
    public void LinesLeftOut_AreMetByTheOthers()
    {
        using OpenedEphemeris engine = Engines.BuiltIn();
        List<string> notes = [];
        StateSamples all = Read(engine, notes);
        StateSamples thin = new() { Interpolation = all.Interpolation };
        for (int i = 0; i < all.Count; i += 2)
        {
            thin.Add(all.Times[i], all[i]);
        }

        bool[] isJoint = [.. Enumerable.Range(0, all.Count).Select(i => i > 0 && Contradicts(all, i))];
        List<double> errors = [];
        for (int i = 601; i < all.Count - 600; i += 2) // 2022-11-17 to 12-10
        {
            if (!isJoint.AsSpan(i - Reach + 1, 2 * Reach).Contains(true))
            {
                errors.Add((thin.At(all.Times[i]).Position - all[i].Position).Length);
            }
        }

        errors.Sort();
        Assert.Equal(9211, all.Count);
        Assert.InRange(isJoint.Count(joint => joint), 70, 76);
        Assert.Equal(2, notes.Count);
        Assert.StartsWith("orion, line 9231: STOP_TIME = '2022-12-11T17:20:44", notes[0], StringComparison.Ordinal);
        Assert.Contains("and so 73 times, most in line 2809 by 260.11 km", notes[1]);
        Assert.InRange(errors.Count, 3000, 4500);
        Assert.InRange(errors[errors.Count / 2], 0.0, 1e-4);
        Assert.InRange(errors[errors.Count * 99 / 100], 0.0, 0.5);
        Assert.InRange(errors[^1], 0.0, 2000.0);
    }

    /// <summary>NASA has 81 miles over the ground at 12:57 UTC on 21 November, 79.2 miles at 16:43 on 5 December.</summary>
    [RequiresTheory(Part.Artemis)]
    [InlineData(59904.5396, 131.0)]
    [InlineData(59918.6965, 128.0)]
    public void ClosestApproaches_AreThoseThatNasaPublished(double mjd, double kilometres)
    {
        using OpenedEphemeris engine = Engines.BuiltIn();
        using FileStream stream = File.OpenRead(TestParts.ArtemisOem!);
        SampledTrajectory trajectory = new(new CcsdsFile(engine, _ => { }).ReadOem(stream, "orion"), "orion", engine.Engine);
        double time = engine.Engine.TimeScale.InstantOfMjd(mjd).Tdb.Seconds;

        double least = Enumerable.Range(-300, 601).Min(second => trajectory.StateJ2000(time + second).Position.Length);

        Assert.Equal(kilometres, (least - 1_737_400.0) / 1000.0, 4.0); // the ground is up to 3 km higher or lower
    }

    private static StateSamples Read(OpenedEphemeris engine, List<string> notes)
    {
        using FileStream stream = File.OpenRead(TestParts.ArtemisOem!);
        return Assert.Single(new CcsdsFile(engine, notes.Add).ReadOem(stream, "orion")).Samples;
    }

    private static bool Contradicts(StateSamples samples, int i)
    {
        double step = samples.Times[i] - samples.Times[i - 1];
        (StateVector before, StateVector after) = (samples[i - 1], samples[i]);
        return (after.Position - before.Position - (step / 2.0 * (before.Velocity + after.Velocity))).Length
            > 1.0 + (step / 4.0 * (after.Velocity - before.Velocity).Length);
    }
}
