namespace Msisf.App.Settings.Specs;

/// <summary>
/// Attaches the affected options to an exception, so that its message can say where in a configuration file they are set.
/// </summary>
internal static class OptionErrors
{
    /// <summary>Adds options to an exception.</summary>
    /// <param name="options">The options that its message is about.</param>
    public static TException About<TException>(this TException exception, params OptionSpec[] options)
        where TException : MsisfException
    {
        exception.Options = [.. exception.Options, .. options.Select(option => option.Name)];
        return exception;
    }

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
    /// <exception cref="UsageException">The value is wrong.</exception>
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

    /// <summary>Makes a value, and puts the option's name before the message of any exception.</summary>
    /// <exception cref="UsageException">The value is wrong.</exception>
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
    }
}
