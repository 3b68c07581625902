using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using System.Text.Json;

namespace Msisf.App.Serving;

/// <summary>The trajectory that a request itself has: its "states".</summary>
internal static class RequestStates
{
    public const string Key = "states";

    private const int Degree = 7;

    private static readonly string[] Names = ["MJD", "rx", "ry", "rz", "vx", "vy", "vz"];

    /// <summary>Reads states in the order of time.</summary>
    /// <param name="rows">For each its time (UTC; an MJD, or ISO 8601), position (m) and velocity (m/s).</param>
    /// <param name="frame">Their axes.</param>
    /// <exception cref="UsageException">The first thing that is wrong, by the number of the state.</exception>
    public static SampledPosition Read(JsonElement rows, OrbitFrame frame)
    {
        if (frame == OrbitFrame.MoonMeEpoch)
        {
            throw CameraOptions.OrbitFrame.Wrong($"of '{Key}' is moon-me or j2000: states of many times have no one epoch.");
        }

        List<(CalendarTime Time, StateVector State)> states = [];
        foreach (JsonElement row in rows.EnumerateArray())
        {
            string where = Invariant($"'{Key}', state {states.Count + 1}");
            double[] numbers = Numbers(row, where);
            CalendarTime time = TimeOf(row[0], where);
            if (states.Count > 0 && time <= states[^1].Time)
            {
                throw new UsageException($"{where}: its time is not after that of the state before. Put them into the order of time.");
            }

            states.Add((time, new StateVector(new Vector3D(numbers[1], numbers[2], numbers[3]), new(numbers[4], numbers[5], numbers[6]))));
        }

        return states.Count > 0
            ? new SampledPosition($"'{Key}'", kernels => [Block(states, frame, kernels.Engine.TimeScale)])
            : throw new UsageException($"'{Key}' is empty. Give states, {string.Join(' ', Names)} each, or the name of a trajectory.");
    }

    private static TrajectoryBlock Block(List<(CalendarTime Time, StateVector State)> states, OrbitFrame frame, TimeScale scale)
    {
        StateSamples samples = new();
        foreach ((CalendarTime time, StateVector state) in states)
        {
            samples.Add(scale.InstantOf(time).Tdb, state);
        }

        if (!samples.HasVelocities)
        {
            samples.Interpolation = new Interpolation(InterpolationMethod.Lagrange, Degree);
        }

        return new TrajectoryBlock(
            samples, CelestialBody.Moon.NaifNumber, frame == OrbitFrame.J2000 ? null : RotationMatrix.Identity);
    }

    private static double[] Numbers(JsonElement row, string where)
    {
        double[] numbers = row.ValueKind == JsonValueKind.Array
            ? [.. row.EnumerateArray().Select((value, index) => value.ValueKind == JsonValueKind.Number ? value.GetDouble()
                : index == 0 && value.ValueKind == JsonValueKind.String ? 0.0 : double.NaN)]
            : [];
        return numbers.Length == Names.Length && numbers.All(double.IsFinite)
            ? numbers
            : throw new UsageException($"{where}: a list of {Names.Length} finite numbers is needed: {string.Join(' ', Names)}.");
    }

    private static CalendarTime TimeOf(JsonElement time, string where)
    {
        try
        {
            return time.ValueKind == JsonValueKind.String ? TimeText.Parse(time.GetString()) : CalendarTime.OfMjd(time.GetDouble());
        }
        catch (BadInputException wrong)
        {
            throw new UsageException($"{where}: {wrong.Message}", wrong);
        }
    }
}

/// <summary>Lists in a request that hold what is in the lines of a file on the command line.</summary>
internal static class RequestRows
{
    /// <summary>The lines: what is in each list, with spaces between.</summary>
    /// <param name="rows">A list of lists of numbers or words.</param>
    /// <param name="key">For messages.</param>
    /// <param name="needed">What is needed, for messages.</param>
    /// <exception cref="UsageException">It is another thing.</exception>
    public static string Text(JsonElement rows, string key, string needed) =>
        rows.ValueKind == JsonValueKind.Array && rows.EnumerateArray().All(row => row.ValueKind == JsonValueKind.Array
            && row.EnumerateArray().All(value => value.ValueKind is JsonValueKind.Number or JsonValueKind.String))
            ? string.Concat(rows.EnumerateArray().Select(row => $"{JsonText.Joined(row, " ", $"'{key}'")}\n"))
            : throw new UsageException($"'{key}' is {JsonText.Shown(rows)}; {needed}, is needed.");
}
