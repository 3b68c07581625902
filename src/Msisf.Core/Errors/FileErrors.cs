namespace Msisf.Core.Errors;

/// <summary>Turns the two exceptions by which .NET reports a file system error into exceptions of this program.</summary>
public static class FileErrors
{
    /// <summary>Whether the exception reports a file system error.</summary>
    public static bool IsFileError(this Exception exception) => exception is IOException or UnauthorizedAccessException;

    /// <summary>Works on a file that the user gave.</summary>
    /// <typeparam name="T">Type of the result.</typeparam>
    /// <param name="problem">Begins the message of a failure: "model.lbl: can't be read".</param>
    /// <param name="work">What is done with the file.</param>
    /// <exception cref="BadInputException">The file system reports an error.</exception>
    public static T ToBadInput<T>(string problem, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new BadInputException($"{problem}: {exception.Message}", exception);
        }
    }

    /// <summary>Works on a file of the program's own.</summary>
    /// <typeparam name="T">Type of the result.</typeparam>
    /// <param name="problem">Begins the message of a failure: "out.png: can't be written".</param>
    /// <param name="work">What is done with the file.</param>
    /// <exception cref="ExternalPartException">The file system reports an error.</exception>
    public static T ToExternalPart<T>(string problem, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException($"{problem}: {exception.Message}", exception);
        }
    }

    /// <summary>Works on a file of the program's own, without a result.</summary>
    /// <param name="problem">Begins the message of a failure.</param>
    /// <param name="work">What is done with the file.</param>
    /// <exception cref="ExternalPartException">The file system reports an error.</exception>
    public static void ToExternalPart(string problem, Action work) => ToExternalPart(problem, () =>
    {
        work();
        return true;
    });
}
