using System.CommandLine;
using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Options;

/// <summary>Thesis table 6.1: which argument goes with which mode.</summary>
internal static class ModeRules
{
    /// <summary>Finds the mode and checks every other argument against it.</summary>
    /// <returns>The mode, or null if no mode argument was given at all.</returns>
    /// <exception cref="UsageException">Two modes, or an argument that is missing or forbidden in the mode.</exception>
    public static Mode? Check(ModeOptions options, Func<Option, bool> isGiven)
    {
        (Option Option, Mode Mode)[] modes =
        [
            (options.KeplerSet, Mode.Kepler), (options.StateVectors, Mode.StateVectors),
            (options.FixedState, Mode.FixedState), (options.BatchFile, Mode.BatchFile),
        ];
        (Option Option, Mode Mode)[] given = [.. modes.Where(candidate => isGiven(candidate.Option))];
        if (given.Length == 0)
        {
            return null;
        }

        if (given.Length > 1)
        {
            throw new UsageException(
                $"{given[0].Option.Name} and {given[1].Option.Name} exclude each other. "
                    + $"Give exactly one of {Names(modes.Select(m => m.Option))}.");
        }

        (Option modeOption, Mode mode) = given[0];
        Option[] times = [options.Time, options.Times, options.TimeInterval];
        if (mode is Mode.Kepler or Mode.StateVectors)
        {
            Require(isGiven, modeOption, options.Epoch);
            RequireOneTime(isGiven, modeOption, times);
            if (isGiven(options.AttitudeTransition) && !isGiven(options.Attitude))
            {
                throw new UsageException("--attitude-transition needs --attitude: the orientation at the epoch from which it turns.");
            }
        }
        else
        {
            Option[] forbidden = [options.Epoch, .. times, options.Attitude, options.AttitudeTransition, options.OrbitFrame];
            if (forbidden.FirstOrDefault(isGiven) is Option wrong)
            {
                throw new UsageException(
                    $"{wrong.Name} is not allowed with {modeOption.Name}, which itself says time, position and orientation. Remove it.");
            }
        }

        return mode;
    }

    /// <summary>The mode arguments, for messages.</summary>
    public static string ModeNames(ModeOptions options) =>
        Names([options.KeplerSet, options.StateVectors, options.FixedState, options.BatchFile]);

    private static void Require(Func<Option, bool> isGiven, Option mode, Option needed)
    {
        if (!isGiven(needed))
        {
            throw new UsageException($"{mode.Name} needs {needed.Name}: the time (MJD, UTC) for which the orbit is given.");
        }
    }

    private static void RequireOneTime(Func<Option, bool> isGiven, Option mode, Option[] times)
    {
        Option[] given = [.. times.Where(isGiven)];
        if (given.Length == 0)
        {
            throw new UsageException($"{mode.Name} needs one of {Names(times)}: when to take images.");
        }

        if (given.Length > 1)
        {
            throw new UsageException($"{given[0].Name} and {given[1].Name} exclude each other. Give exactly one of {Names(times)}.");
        }
    }

    private static string Names(IEnumerable<Option> options) => string.Join(", ", options.Select(option => option.Name));
}
