namespace Msisf.App.Settings.Specs;

/// <summary>
/// Attaches the affected options to an exception, so that its message can say where in a configuration file they are set.
/// </summary>
internal static class OptionErrors
{
    /// <param name="options">The options that its message is about.</param>
    public static TException About<TException>(this TException exception, params OptionSpec[] options)
        where TException : MsisfException
    {
        exception.Options = [.. exception.Options, .. options.Select(option => option.Name)];
        return exception;
    }

    /// <summary>The failure that an option is wrong.</summary>
    /// <param name="why">What follows its name: "is given twice. Leave one out."</param>
    /// <param name="others">Options that contradict it.</param>
    public static UsageException Wrong(this OptionSpec option, string why, params OptionSpec[] others) =>
        new UsageException($"{option.Name} {why}").About([option, .. others]);

    /// <summary>Refuses the first of some options that is given.</summary>
    /// <param name="why">What follows its name: "is not allowed with --batch-file. Remove it."</param>
    /// <param name="others">Options that contradict it.</param>
    /// <exception cref="UsageException">One of them is given.</exception>
    public static void Refuse(this OptionValues values, IEnumerable<OptionSpec> options, string why, params OptionSpec[] others)
    {
        if (options.FirstOrDefault(values.IsGiven) is { } wrong)
        {
            throw wrong.Wrong(why, others);
        }
    }

    /// <summary>Refuses several times of a run, and none.</summary>
    /// <param name="way">The option that says where the camera is.</param>
    /// <param name="times">The options that say when.</param>
    /// <exception cref="UsageException">Not exactly one of them is given.</exception>
    public static void RequireTimes(this OptionValues values, OptionSpec way, IReadOnlyList<OptionSpec> times)
    {
        OptionSpec[] given = [.. times.Where(values.IsGiven)];
        if (given.Length != 1)
        {
            throw new UsageException(given.Length == 0
                ? $"{way.Name} needs one of {times.Names()}: when to take images."
                : $"{given[0].Name} and {given[1].Name} exclude each other. Give exactly one of {times.Names()}.");
        }
    }

    /// <summary>The options' names for a message.</summary>
    public static string Names(this IEnumerable<OptionSpec> options) => string.Join(", ", options.Select(option => option.Name));

    /// <summary>Runs work on an option's value, and adds the option to any exception.</summary>
    public static T NamedInErrors<T>(this OptionSpec option, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (MsisfException exception)
        {
            exception.About(option);
            throw;
        }
    }

    /// <summary>Checks an option's value, and adds the option to any exception.</summary>
    public static void NamedInErrors(this OptionSpec option, Action work) => option.NamedInErrors(() =>
    {
        work();
        return true;
    });

    /// <summary>Reads an option's value; a wrong one is a wrong option, whatever the code that reads it makes of it.</summary>
    public static T Value<T>(this OptionSpec option, Func<T> read)
    {
        try
        {
            return option.NamedInErrors(read);
        }
        catch (BadInputException exception)
        {
            throw new UsageException(exception.Message, exception).About(option);
        }
    }

    /// <summary>Makes a value, and puts the option's name before the message of a wrong value, or of kernels that can't make it.</summary>
    public static T Named<T>(this OptionSpec option, Func<T> make)
    {
        try
        {
            return make();
        }
        catch (BadInputException exception)
        {
            throw new UsageException($"{option.Name}: {exception.Message}", exception).About(option);
        }
        catch (SpiceException exception)
        {
            throw new SpiceException($"{option.Name}: {exception.Message}", exception).About(option);
        }
    }
}
