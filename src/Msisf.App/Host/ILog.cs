namespace Msisf.App.Host;

/// <summary>Writes messages for the user, separate from the results. Thread-safe.</summary>
internal interface ILog
{
    /// <summary>Writes information about the progress of the work.</summary>
    void Note(string text);

    /// <summary>Writes a warning; the run continues.</summary>
    void Warning(string text);

    /// <summary>Writes an error.</summary>
    void Error(string text);

    /// <summary>Writes a line unchanged, for other programs to read.</summary>
    void Raw(string line);
}
