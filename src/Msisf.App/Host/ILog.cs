namespace Msisf.App.Host;

/// <summary>Messages for the user, apart from results. Safe for several threads.</summary>
internal interface ILog
{
    /// <summary>What is going on.</summary>
    void Note(string text);

    /// <summary>What may be wrong; the run goes on.</summary>
    void Warning(string text);

    /// <summary>What failed.</summary>
    void Error(string text);

    /// <summary>A line as it is, for machines.</summary>
    void Raw(string line);
}
