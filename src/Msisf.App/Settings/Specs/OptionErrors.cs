using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>
/// Says of a failure which options it is about, so that the place of a setting in a configuration file can be told with it.
/// </summary>
internal static class OptionErrors
{
    /// <summary>Adds options to a failure.</summary>
    /// <param name="exception">The failure.</param>
    /// <param name="options">Those that its message is about.</param>
    public static TException About<TException>(this TException exception, params OptionSpec[] options)
        where TException : MsisfException
    {
        exception.Options = [.. exception.Options, .. options.Select(option => option.Name)];
        return exception;
    }

    /// <summary>Does something with an option's value; a failure is about that option.</summary>
    public static T Concerned<T>(this OptionSpec option, Func<T> work)
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

    /// <summary>The same for a value that is only checked.</summary>
    public static void Concerned(this OptionSpec option, Action work) => option.Concerned(() =>
    {
        work();
        return true;
    });

    /// <summary>Makes a value; what is wrong with it is told with the option's name before it.</summary>
    public static T Named<T>(this OptionSpec option, Func<T> make)
    {
        try
        {
            return make();
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($"{option.Name}: {exception.Message}", exception).About(option);
        }
    }
}
